// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/tick_log.hpp"

#include <algorithm>

#include "tests/engine/recording/made_up_ticks.hpp"

namespace sonde::test {
namespace {

TEST(TickLog, any_tick_is_found_by_its_place_and_its_time) {
  const std::vector<Snapshot> ticks = made_up_ticks(1700);  // three blocks and a part of one
  TickLog log(made_up_radius, 1000);
  EXPECT_TRUE(log.empty());
  for (const Snapshot& tick : ticks) EXPECT_TRUE(log.add(tick));
  EXPECT_EQ(log.begin(), 0u);
  EXPECT_EQ(log.end(), ticks.size());
  EXPECT_EQ(log.first_time(), 0);
  EXPECT_EQ(log.last_time(), ticks.back().time);
  for (std::size_t i = 0; i < ticks.size(); i += 7) {
    EXPECT_EQ(log.at(i).separation.device.p, ticks[i].separation.device.p) << i;
    EXPECT_EQ(log.find(ticks[i].time), i);
    EXPECT_EQ(log.find(ticks[i].time + 4e-4), i) << "the last that is not later";
  }
  EXPECT_EQ(log.find(-1), 0u);
  EXPECT_EQ(log.find(99), ticks.size() - 1);
  EXPECT_THROW(log.at(ticks.size()), std::out_of_range);
}

TEST(TickLog, the_oldest_ticks_go_where_there_are_more_than_are_kept) {
  const std::vector<Snapshot> ticks = made_up_ticks(5000);
  TickLog log(made_up_radius, 1000, {.ticks = 2000});
  for (const Snapshot& tick : ticks) log.add(tick);
  EXPECT_EQ(log.end(), 5000u);
  EXPECT_LE(log.end() - log.begin(), 2000u);
  EXPECT_GT(log.end() - log.begin(), 2000u - TickLog::block_ticks - 1);
  EXPECT_EQ(log.at(log.begin()).time, ticks[log.begin()].time);
  EXPECT_EQ(log.first_time(), ticks[log.begin()].time);
  EXPECT_THROW(log.at(log.begin() - 1), std::out_of_range);
}

TEST(TickLog, memory_is_bounded_by_bytes_too) {
  constexpr std::size_t most = 6'000'000;
  TickLog log(made_up_radius, 1000, {.ticks = 1'000'000, .bytes = most});
  for (int run = 0; run < 10; ++run)
    for (const Snapshot& tick : made_up_ticks(1024, std::uint64_t(run))) {
      log.add(tick);
      ASSERT_LE(log.bytes(), most);
    }
  EXPECT_GT(log.begin(), 0u);
}

TEST(TickLog, a_servo_that_starts_again_goes_on_in_time) {
  const std::vector<Snapshot> ticks = made_up_ticks(10);
  TickLog log(made_up_radius, 1000);
  for (int run = 0; run < 3; ++run)
    for (const Snapshot& tick : ticks) log.add(tick);
  ASSERT_EQ(log.end(), 30u);
  for (std::uint64_t i = 0; i < 30; ++i) EXPECT_NEAR(log.at(i).time, 1e-3 * double(i), 1e-12);
  EXPECT_EQ(log.at(10).tick, 1u) << "which tells that it began again";
}

TEST(TickLog, ticks_of_a_pause_are_left_out) {
  std::vector<Snapshot> ticks = made_up_ticks(3);
  TickLog log(made_up_radius, 1000);
  log.add(ticks[0]);
  ticks[0].paused = true;
  EXPECT_FALSE(log.add(ticks[0]));
  log.add(ticks[1]);
  EXPECT_EQ(log.end(), 2u);
}

TEST(TickLog, the_newest_search_of_a_time) {
  TickLog log(made_up_radius, 1000);
  EXPECT_EQ(log.searched(0), nullptr);
  const std::vector<Snapshot> ticks = made_up_ticks(1200);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    log.add(ticks[i]);
    if (i % 100 == 50) log.add(made_up_search(double(i)));
  }
  EXPECT_EQ(log.searched(0.0499), nullptr);
  ASSERT_NE(log.searched(0.05), nullptr);
  EXPECT_EQ(log.searched(0.05)->result.time_us, 50);
  EXPECT_EQ(log.searched(0.2499)->result.time_us, 150);
  EXPECT_EQ(log.searched(9)->result.time_us, 1150);
}

TEST(TickLog, blocks_are_handed_on_as_they_are_made) {
  TickLog log(made_up_radius, 1000);
  std::size_t ticks = 0, searches = 0;
  log.sealed = [&](const std::shared_ptr<const std::string>& block) {
    const BlockHead head = head_of(*block);
    (head.kind == BlockKind::ticks ? ticks : searches) += head.rows;
  };
  for (const Snapshot& tick : made_up_ticks(1000)) log.add(tick);
  log.add(BackgroundResult{});
  EXPECT_EQ(ticks, TickLog::block_ticks);
  log.seal();
  EXPECT_EQ(ticks, 1000u);
  EXPECT_EQ(searches, 1u);
}

}  // namespace
}  // namespace sonde::test
