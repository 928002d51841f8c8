// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/playback.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sonde::ui::test {
namespace {

/// Two seconds at 1 kHz; the depth of each tick says which it is.
TickLog two_seconds() {
  TickLog log(0.05, 1000);
  Snapshot tick;
  for (int i = 0; i < 2001; ++i) {
    tick.tick = static_cast<std::uint64_t>(i) + 1;
    tick.time = 1e-3 * i;
    tick.separation.depth = i;
    log.add(tick);
    if (i == 1000) {
      BackgroundResult search;
      search.lower_bound = 0.25;
      log.add(search);
    }
  }
  return log;
}

TEST(Playback, an_instant_is_the_tick_and_what_was_known_then) {
  const TickLog log = two_seconds();
  Playback playback;
  EXPECT_FALSE(playback.looking());
  playback.look_at(&log);
  ASSERT_TRUE(playback.looking());
  EXPECT_EQ(playback.instant().snapshot.separation.depth, 2000) << "begins at the end";
  playback.seek(0.5004);
  const Instant then = playback.instant();
  EXPECT_EQ(then.snapshot.separation.depth, 500);
  EXPECT_FALSE(then.live);
  EXPECT_FALSE(then.searched) << "the search had not ended";
  playback.seek(1.2);
  ASSERT_TRUE(playback.instant().searched);
  EXPECT_EQ(playback.instant().searched->lower_bound, 0.25);
}

TEST(Playback, a_tick_forgotten_while_it_is_on_show_gives_way_to_the_oldest_kept) {
  TickLog log(0.05, 1000, {.ticks = 2 * TickLog::block_ticks, .bytes = 0});
  Snapshot tick;
  const auto add = [&](std::size_t count) {
    for (; count > 0; --count) {
      tick.separation.depth = static_cast<double>(tick.tick++);
      tick.time = 1e-3 * static_cast<double>(tick.tick);
      log.add(tick);
    }
    log.seal();
  };
  add(TickLog::block_ticks);
  Playback playback;
  playback.look_at(&log);
  playback.seek(0);
  ASSERT_EQ(playback.instant().snapshot.separation.depth, 0);
  add(3 * TickLog::block_ticks);
  ASSERT_GT(log.begin(), 0u);
  EXPECT_EQ(playback.index(), log.begin());
  EXPECT_EQ(playback.instant().snapshot.separation.depth, static_cast<double>(log.begin()));
  playback.step(1);
  EXPECT_EQ(playback.index(), log.begin() + 1);
}

TEST(Playback, steps_go_by_ticks_and_stay_within) {
  const TickLog log = two_seconds();
  Playback playback;
  playback.look_at(&log);
  playback.seek(1);
  playback.step(-1);
  EXPECT_EQ(playback.instant().snapshot.separation.depth, 999);
  playback.step(3);
  EXPECT_EQ(playback.instant().snapshot.separation.depth, 1002);
  playback.step(-5000);
  EXPECT_EQ(playback.index(), 0u);
  playback.step(5000);
  EXPECT_EQ(playback.index(), 2000u);
}

TEST(Playback, plays_at_the_speed_asked_for) {
  const TickLog log = two_seconds();
  Playback playback;
  playback.look_at(&log);
  playback.seek(0.1);
  playback.play(true);
  playback.set_speed(0.01);
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(playback.advance(0.02));
  EXPECT_NEAR(playback.time(), 0.11, 1e-9) << "a second of slow motion";
  playback.set_speed(100);
  EXPECT_EQ(playback.speed(), Playback::fastest);
  playback.advance(0.1);
  EXPECT_NEAR(playback.time(), 0.51, 1e-9);
  playback.set_speed(std::nan(""));
  EXPECT_EQ(playback.speed(), Playback::fastest);
}

TEST(Playback, ends_at_the_end_or_begins_anew) {
  const TickLog log = two_seconds();
  Playback playback;
  playback.look_at(&log);
  playback.play(true);
  EXPECT_EQ(playback.time(), 0) << "at the end it begins anew";
  playback.advance(1.5);
  EXPECT_TRUE(playback.advance(1));
  EXPECT_EQ(playback.time(), 2);
  EXPECT_FALSE(playback.playing());
  EXPECT_FALSE(playback.advance(1));
  playback.set_loop(true);
  playback.play(true);
  playback.advance(1.5);
  playback.advance(1);
  EXPECT_EQ(playback.time(), 0);
  EXPECT_TRUE(playback.playing());
}

TEST(Playback, nothing_to_look_at_moves_nothing) {
  const TickLog none(0.05, 1000);
  Playback playback;
  playback.look_at(&none);
  EXPECT_FALSE(playback.looking());
  playback.seek(1);
  playback.step(1);
  playback.play(true);
  EXPECT_FALSE(playback.playing());
  EXPECT_FALSE(playback.advance(1));
}

}  // namespace
}  // namespace sonde::ui::test
