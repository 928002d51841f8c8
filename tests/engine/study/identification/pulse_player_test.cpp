// SPDX-License-Identifier: GPL-3.0-or-later
// References: the plan, and handles that move as the test says.
#include "engine/study/identification/pulse_player.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/engine/study/identification/plan_along.hpp"
#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

using test::device_of_force;

constexpr double period = 1e-3;
/// Where the handle begins: any place.
const Pose handle_start{Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())),
                        Vec3(0.1, 0.2, 0.3)};

struct Bench {
  PulsePlan plan = plan_pulses(device_of_force(), {}, period);
  PulseBounds bounds = bounds_of(plan, {});
  PulsePlayer player{plan, bounds};
  double most_force = 0, most_torque = 0;
  int ticks = 0;

  /// A tick with the handle there; returns what it asked for.
  Wrench tick(const Pose& X_BH, Withheld why = Withheld::nothing, bool trusted = true) {
    HandTrial& trial = player.next(period * ticks++, X_BH, trusted);
    Wrench asked = trial.wrench;
    most_force = std::max(most_force, asked.force.norm());
    most_torque = std::max(most_torque, asked.torque.norm());
    trial.withheld = why;
    player.rendered(why == Withheld::nothing ? asked : Wrench{});
    return asked;
  }
  PulsesEnd end() const { return player.progress().end; }
  /// Until a pulse pushes.
  void to_a_pulse(const Pose& at = handle_start) {
    while (tick(at).force.isZero(0) && end() == PulsesEnd::none) continue;
  }
  /// It ended so, and asks for nothing any more, whatever happens.
  void expect_ended(PulsesEnd why) {
    EXPECT_EQ(end(), why);
    for (int i = 0; i < 1000; ++i) {
      const Wrench asked = tick(handle_start);
      ASSERT_TRUE(asked.force.isZero(0) && asked.torque.isZero(0));
    }
    EXPECT_EQ(end(), why);
  }
};

Pose moved(const Vec3& by, const Vec3& turned = Vec3::Zero()) {
  const double angle = turned.norm();
  const Quat turn(Eigen::AngleAxisd(angle, angle > 0 ? Vec3(turned / angle) : Vec3::UnitX()));
  return {turn * handle_start.q, handle_start.p + by};
}

TEST(PulsePlayer, plays_the_plan_and_records_what_was_rendered_with_the_pose_of_the_tick) {
  Bench bench;
  const std::vector<Wrench> plan = commands_of(bench.plan);
  EXPECT_EQ(bench.player.progress().samples, plan.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    ASSERT_EQ(bench.end(), PulsesEnd::none) << i;
    const Wrench asked = bench.tick(handle_start);
    EXPECT_EQ(asked.force, plan[i].force) << i;
    EXPECT_EQ(asked.torque, plan[i].torque) << i;
  }
  EXPECT_EQ(bench.end(), PulsesEnd::done);
  const Response recorded = bench.player.response();
  ASSERT_EQ(recorded.size(), plan.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    EXPECT_EQ(recorded[i].command.force, plan[i].force);
    EXPECT_EQ(recorded[i].X_BH.p, handle_start.p);
    EXPECT_DOUBLE_EQ(recorded[i].t, period * double(i));
  }
  EXPECT_EQ(bench.player.progress().pulse, bench.plan.pulses.size());
  bench.expect_ended(PulsesEnd::done);
  EXPECT_EQ(bench.player.response().size(), plan.size()) << "nothing is added after the end";
}

TEST(PulsePlayer, what_the_loop_made_of_a_command_is_what_is_recorded) {
  Bench bench;
  for (int i = 0; i < 300; ++i) {
    HandTrial& trial = bench.player.next(period * i, handle_start, true);
    EXPECT_EQ(trial.max_force, bench.bounds.force);
    bench.player.rendered({.force = 0.5 * trial.wrench.force});
  }
  const Response recorded = bench.player.response();
  EXPECT_DOUBLE_EQ(recorded.back().command.force.norm(),
                   0.5 * std::abs(bench.plan.pulses[0].amplitude));
}

TEST(PulsePlayer, never_asks_for_more_than_the_limits) {
  Bench bench;
  while (bench.end() == PulsesEnd::none) bench.tick(handle_start);
  EXPECT_DOUBLE_EQ(bench.most_force, 2);
  EXPECT_DOUBLE_EQ(bench.most_torque, 0.05);
  EXPECT_DOUBLE_EQ(bench.bounds.force, 2);
  EXPECT_DOUBLE_EQ(bench.bounds.torque, 0.05);
}

TEST(PulsePlayer, ends_where_the_loop_withholds_the_force_and_keeps_the_reason) {
  Bench bench;
  bench.tick(handle_start, Withheld::changed);  // as every hand begins
  bench.to_a_pulse();
  bench.tick(handle_start, Withheld::stopped);
  EXPECT_TRUE(bench.tick(handle_start).force.isZero(0));
  EXPECT_EQ(bench.player.progress().withheld, Withheld::stopped);
  bench.expect_ended(PulsesEnd::withheld);
}

TEST(PulsePlayer, ends_when_it_is_stopped) {
  Bench bench;
  bench.to_a_pulse();
  bench.player.stop();
  EXPECT_TRUE(bench.tick(handle_start).force.isZero(0));
  bench.expect_ended(PulsesEnd::stopped);
}

TEST(PulsePlayer, ends_where_the_device_is_lost_or_says_what_is_no_number) {
  Bench bench;
  bench.to_a_pulse();
  EXPECT_TRUE(bench.tick(handle_start, Withheld::nothing, false).force.isZero(0));
  bench.expect_ended(PulsesEnd::lost);
  Bench other;
  Pose none = handle_start;
  none.p.x() = std::numeric_limits<double>::quiet_NaN();
  other.to_a_pulse();
  EXPECT_TRUE(other.tick(none).force.isZero(0));
  other.expect_ended(PulsesEnd::lost);
}

TEST(PulsePlayer, ends_where_the_handle_goes_too_far) {
  Bench bench;
  bench.to_a_pulse();
  bench.tick(moved({0.029, 0, 0}));
  EXPECT_EQ(bench.end(), PulsesEnd::none);
  EXPECT_TRUE(bench.tick(moved({0.02, 0.02, 0.02})).force.isZero(0));
  bench.expect_ended(PulsesEnd::drifted);
  Bench turning;
  turning.to_a_pulse();
  turning.tick(moved({0, 0, 0}, {0, 1, 0}));
  turning.expect_ended(PulsesEnd::drifted);
}

TEST(PulsePlayer, does_not_begin_before_the_handle_rests) {
  Bench bench;
  int ticks = 0;
  for (; ticks < 2000 && bench.end() == PulsesEnd::none; ++ticks)
    bench.tick(moved({0.01e-3 * ticks, 0, 0}));  // 10 mm/s
  EXPECT_EQ(bench.most_force, 0);
  EXPECT_GT(ticks, 4 * 250) << "it is given time";
  EXPECT_LT(ticks, 6 * 250) << "and not for ever";
  bench.expect_ended(PulsesEnd::restless);
}

// A pulse that a late tick made longer leaves a heavy handle moving: the plan goes on where it
// rests.
TEST(PulsePlayer, waits_for_a_handle_that_comes_to_rest_late) {
  Bench bench;
  static constexpr int moving = 600;
  const auto at = [](int tick) { return moved({0, 0, 0.01e-3 * std::min(tick, moving)}); };
  ASSERT_NE(bench.plan.pulses[0].axis, 2u) << "else it looks held when it no longer moves";
  int tick = 0;
  for (; bench.most_force == 0; ++tick) {
    ASSERT_LT(tick, 2000);
    bench.tick(at(tick));
  }
  EXPECT_GT(tick, moving) << "no pulse before it rests";
  EXPECT_LT(tick, moving + 250);
  for (; bench.end() == PulsesEnd::none; ++tick) bench.tick(at(tick));
  EXPECT_EQ(bench.end(), PulsesEnd::done);
  const std::size_t planned = commands_of(bench.plan).size();
  EXPECT_EQ(bench.player.progress().sample, planned);
  EXPECT_GT(bench.player.response().size(), planned) << "what was waited is in the recording";
  EXPECT_EQ(bench.player.response().size(), static_cast<std::size_t>(bench.ticks));
}

TEST(PulsePlayer, a_handle_that_slides_to_rest_after_a_pulse_may) {
  Bench bench;
  const std::size_t pulse = bench.plan.rest + 4 * bench.plan.pulses[0].part;
  for (std::size_t i = 0; i < pulse; ++i) bench.tick(handle_start);
  for (std::size_t i = 0; i < 160; ++i) bench.tick(moved({0.02e-3 * double(i), 0, 0}));
  for (std::size_t i = 0; i < 200; ++i) bench.tick(moved({3.2e-3, 0, 0}));
  EXPECT_EQ(bench.end(), PulsesEnd::none);
}

/// Moves by as much as `ways` say of each pulse, in its middle.
PulsesEnd played(Bench& bench, const std::vector<double>& ways) {
  std::size_t begin = bench.plan.rest;
  std::size_t i = 0;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const std::size_t middle = begin + 2 * bench.plan.pulses[k].part;
    const std::size_t end = begin + 4 * bench.plan.pulses[k].part;
    for (; i <= end; ++i) bench.tick(i == middle ? moved({ways[k], 0, 0}) : handle_start);
    begin = end + bench.plan.rest;
  }
  return bench.end();
}

TEST(PulsePlayer, a_grip_shows_in_a_larger_pulse_that_moves_less) {
  Bench grabbed;
  EXPECT_EQ(played(grabbed, {3e-3, 4e-3, 0.5e-3}), PulsesEnd::held);
  grabbed.expect_ended(PulsesEnd::held);
  Bench free;
  EXPECT_EQ(played(free, {3e-3, 4e-3, 3e-3, 5e-3}), PulsesEnd::none) << "gravity may have a side";
}

TEST(PulsePlayer, tells_the_loop_how_the_handle_moved) {
  Bench bench;
  bench.player.next(0, handle_start, true);
  bench.player.rendered({});
  const HandTrial& trial = bench.player.next(period, moved({0, 1e-3, 0}, {0, 0, 0.01}), true);
  EXPECT_LT((trial.way - Vec3(0, 1e-3, 0)).norm(), 1e-15);
  EXPECT_LT((trial.turn - Vec3(0, 0, 0.01)).norm(), 1e-12);
}

TEST(PulsePlayer, a_loop_that_rests_adds_nothing) {
  Bench bench;
  bench.tick(handle_start);
  for (int i = 0; i < 10; ++i) bench.player.rendered({});
  EXPECT_EQ(bench.player.progress().sample, 1U);
}

TEST(PulsePlayer, it_neither_allocates_nor_frees) {
  Bench bench;
  test::AllocationCounter counter;
  for (int i = 0; i < 2000; ++i) bench.tick(handle_start);
  bench.player.stop();
  bench.tick(handle_start);
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0U);
  EXPECT_EQ(bench.end(), PulsesEnd::stopped);
}

}  // namespace
}  // namespace sonde
