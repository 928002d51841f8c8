// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/loop_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/haptics/loop/haptic_loop.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

Pair two_boxes() { return {body(box(Vec3::Constant(0.1))), body(box(Vec3::Constant(0.2)))}; }

/// Into the larger box from the side, and along it.
std::vector<TimedPose> path_into_box() {
  std::vector<TimedPose> path;
  for (int i = 0; i < 200; ++i) {
    const double t = 1e-3 * i;
    path.push_back({t, {Quat::Identity(), Vec3(0.155 - 0.05 * t, 0.03 * std::sin(20 * t), 0)}});
  }
  return path;
}

std::vector<Snapshot> run(const Pair& pair, const std::vector<LoopStep>& steps) {
  std::vector<Snapshot> ticks;
  run_loop(pair, steps, {}, [&](const Snapshot& tick) { ticks.push_back(tick); });
  return ticks;
}

TEST(LoopRun, does_what_the_loop_in_step_does) {
  const Pair pair = two_boxes();
  const Coupling coupling{.mode = Coupling::Mode::classic, .k_t = 300, .b_t = 2};
  const std::vector<TimedPose> path = path_into_box();
  const std::vector<Snapshot> ticks = run(pair, steps_of(path, coupling));
  ASSERT_EQ(ticks.size(), path.size());
  HapticLoop loop(pair, Method::pdg, coupling);  // the reference
  loop.reset(path[0].pose, {});
  for (std::size_t i = 0; i < path.size(); ++i) {
    loop.tick(path[i].pose, i == 0 ? 0 : path[i].t - path[i - 1].t, {});
    EXPECT_EQ(ticks[i].tick, i + 1);
    EXPECT_EQ(ticks[i].time, path[i].t);
    EXPECT_EQ(ticks[i].separation.separated.p, loop.separation().separated.p);
    EXPECT_EQ(ticks[i].separation.depth, loop.separation().depth);
    EXPECT_EQ(ticks[i].wrench.force, loop.wrench().force);
    EXPECT_EQ(ticks[i].coupling.k_t, 300);
  }
  EXPECT_GT(ticks.back().separation.depth, 4e-3);
}

TEST(LoopRun, a_recorded_path_gives_the_same_bits_again) {
  const Pair pair = two_boxes();
  const std::vector<Snapshot> first = run(pair, steps_of(path_into_box(), {}));
  TickLog log(pair.probe().mass.radius, 1000);
  for (const Snapshot& tick : first) log.add(tick);
  log.seal();
  const std::vector<Snapshot> again = run(pair, steps_of(log));
  ASSERT_EQ(again.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(again[i].separation.depth, first[i].separation.depth);
    EXPECT_EQ(again[i].separation.separated.p, first[i].separation.separated.p);
    EXPECT_EQ(again[i].wrench.force, first[i].wrench.force);
    EXPECT_EQ(again[i].wrench.torque, first[i].wrench.torque);
  }
}

TEST(LoopRun, the_gaps_of_a_recorded_path_are_kept) {
  Snapshot tick;
  TickLog log(0.05, 1000);
  log.along_path = true;
  std::vector<TimedPose> path;
  for (const double t : {0.0, 0.5, 0.501, 3.7}) {
    path.push_back({t, Pose{}});
    ++tick.tick;
    tick.time = t;
    log.add(tick);
  }
  const std::vector<LoopStep> wanted = steps_of(path, {}), got = steps_of(log);
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i].dt, wanted[i].dt) << i;
}

TEST(LoopRun, where_the_servo_began_again_the_loop_does) {
  Snapshot tick;
  TickLog log(0.05, 1000);
  for (int run = 0; run < 2; ++run)
    for (std::uint64_t i = 1; i <= 3; ++i) {
      tick.tick = i;
      tick.time = 1e-3 * static_cast<double>(i);
      log.add(tick);
    }
  tick.tick = 900;  // most were lost, or there was a pause
  tick.time = 0.9;
  log.add(tick);
  const std::vector<LoopStep> steps = steps_of(log);
  ASSERT_EQ(steps.size(), 7u);
  const std::vector<bool> begins{true, false, false, true, false, false, false};
  for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_EQ(steps[i].begins, begins[i]) << i;
  EXPECT_EQ(steps[0].dt, 0);
  EXPECT_NEAR(steps[1].dt, 1e-3, 1e-12);
  EXPECT_EQ(steps[3].dt, 0);
  EXPECT_EQ(steps[6].dt, 0) << "a pause damps nothing";
}

}  // namespace
}  // namespace sonde::test
