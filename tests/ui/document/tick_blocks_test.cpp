// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/tick_blocks.hpp"

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/recording/recording.hpp"
#include "tests/engine/recording/made_up_ticks.hpp"

namespace sonde::ui::test {
namespace {

using sonde::test::made_up_radius;
using sonde::test::made_up_search;
using sonde::test::made_up_ticks;

TEST(TickBlocks, hold_every_tick_and_search_of_a_log) {
  const std::vector<Snapshot> ticks = made_up_ticks(1300);
  TickLog log(made_up_radius, 500);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    log.add(ticks[i]);
    if (i % 400 == 399) log.add(made_up_search(double(i)));
  }
  log.seal();
  const TickBlocks blocks = TickBlocks::of(log);
  EXPECT_EQ(blocks.first, log.first_time());
  EXPECT_EQ(blocks.last, log.last_time());
  const TickLog again = blocks.log();
  EXPECT_EQ(again.probe_radius(), made_up_radius);
  EXPECT_EQ(again.rate_hz(), 500);
  EXPECT_FALSE(again.along_path);
  ASSERT_EQ(again.end() - again.begin(), ticks.size());
  for (std::uint64_t i = 0; i < ticks.size(); i += 13) {
    EXPECT_EQ(again.at(i).time, log.at(i).time);
    const Snapshot before = log.at(i), after = again.at(i);
    EXPECT_EQ(after.separation.device.p, before.separation.device.p);
    EXPECT_LT((after.separation.separated.p - before.separation.separated.p).norm(), 1e-9)
        << "the way there is kept to seven digits";
  }
  ASSERT_EQ(again.searches().size(), 3u);
  for (const double time : {0.5, 0.9, 1.25}) {
    ASSERT_TRUE(again.searched(time));
    EXPECT_EQ(again.searched(time)->result.time_us, log.searched(time)->result.time_us) << time;
  }
}

TEST(TickBlocks, know_whether_the_ticks_are_of_a_path) {
  TickLog log(made_up_radius, 1000);
  for (const Snapshot& tick : made_up_ticks(3)) log.add(tick);
  log.seal();
  log.along_path = true;
  EXPECT_TRUE(TickBlocks::of(log).log().along_path);
}

TEST(TickBlocks, stay_as_they_were_while_the_log_goes_on_and_forgets) {
  const std::vector<Snapshot> ticks = made_up_ticks(4000);
  TickLog log(made_up_radius, 1000, {.ticks = 1500});
  for (std::size_t i = 0; i < 1000; ++i) log.add(ticks[i]);
  log.seal();
  const TickBlocks blocks = TickBlocks::of(log);
  for (std::size_t i = 1000; i < ticks.size(); ++i) log.add(ticks[i]);
  ASSERT_GT(log.begin(), 1000u) << "the log has forgotten them";
  const TickLog again = blocks.log();
  ASSERT_EQ(again.end() - again.begin(), 1000u);
  EXPECT_EQ(again.at(0).separation.device.p, ticks[0].separation.device.p);
  EXPECT_EQ(again.last_time(), ticks[999].time);
}

class BlocksOfAFile : public sonde::test::RecordingTest {};

TEST_F(BlocksOfAFile, are_read_again_as_long_as_the_file_has_them) {
  const std::vector<Snapshot> ticks = made_up_ticks(1200);
  const std::filesystem::path file = recording("two.sonderec", ticks);
  TickBlocks blocks;
  {
    const auto read = read_recording(file);
    ASSERT_EQ(read->cut, "");
    blocks = TickBlocks::of(read->ticks);
  }
  const TickLog whole = blocks.log();
  ASSERT_EQ(whole.end(), ticks.size());
  EXPECT_EQ(whole.at(1100).separation.device.p, ticks[1100].separation.device.p);
  for (const std::uintmax_t bytes : {std::filesystem::file_size(file) / 2, std::uintmax_t(0)}) {
    std::filesystem::resize_file(file, bytes);
    EXPECT_THROW(blocks.log(), InputError) << bytes << " bytes are left";
  }
}

TEST(TickBlocks, of_an_empty_log_are_an_empty_log) {
  const TickLog again = TickBlocks::of(TickLog(made_up_radius, 1000)).log();
  EXPECT_TRUE(again.empty());
  EXPECT_TRUE(again.searches().empty());
}

}  // namespace
}  // namespace sonde::ui::test
