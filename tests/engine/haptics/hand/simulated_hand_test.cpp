// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/simulated_hand.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

constexpr double period = 1e-3;
const Vec3 com(0.01, -0.02, 0.03);
const Pose start{Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())), Vec3(0.1, 0.2, 0.3)};

Pose moved(const Pose& pose, const Vec3& by) { return {pose.q, pose.p + by}; }

/// Ticks with a wall, for as long as it takes; the wrench is a spring at `wall`, in x.
Pose run(const Hand& hand, int ticks, double k = 0, double wall = 0) {
  Pose at;
  for (int i = 0; i < ticks; ++i) {
    at = hand.sample(period).X_FM;
    const double depth = (at * com).x() - wall;
    hand.render({.force = Vec3(depth > 0 ? -k * depth : 0, 0, 0)});
  }
  return at;
}

TEST(SimulatedHand, it_rests_where_the_probe_is_until_the_mouse_moves) {
  SimulatedHand simulated({}, period, 1, com, start);
  const Pose at = run(simulated.hand(), 100);
  EXPECT_LT((at.p - start.p).norm(), 1e-14);
  EXPECT_LT(at.q.angularDistance(start.q), 1e-7);
}

TEST(SimulatedHand, the_probe_comes_to_where_the_mouse_wants_it) {
  SimulatedHand simulated({}, period, 1, com, start);
  const Hand hand = simulated.hand();
  run(hand, 10);
  const Pose target{Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX())), Vec3(0.15, 0.2, 0.25)};
  simulated.set_target(target);
  const Pose soon = run(hand, 10);
  EXPECT_GT((soon * com - target * com).norm(), 0.02) << "a hand takes its time";
  const Pose at = run(hand, 2000);
  EXPECT_LT((at * com - target * com).norm(), 1e-9);
  EXPECT_LT(at.q.angularDistance(target.q), 1e-6);
}

/// In a steady state the hand's spring and the wall's balance: k_h (x_h - x) = k (x - wall).
TEST(SimulatedHand, pressed_into_a_wall_two_springs_balance) {
  SimulatedDeviceParameters soft;
  soft.translation.damping = 3;
  for (const double s : {1.0, 2.0}) {
    SimulatedHand simulated(soft, period, s, com, start);
    const Hand hand = simulated.hand();
    const double wall = (start * com).x();
    simulated.set_target(moved(start, Vec3(0.02, 0, 0)));
    const double depth = (run(hand, 4000, 200, wall) * com).x() - wall;
    // In the hand the wall is s² times as stiff.
    const double k_hand = soft.translation.hand_stiffness;
    EXPECT_NEAR(depth, 0.02 * k_hand / (k_hand + s * s * 200), 1e-7);
  }
}

/// A rate that changes in contact: neither the handle nor the hand's push jumps, whatever the
/// delay.
TEST(SimulatedHand, another_rate_in_contact_keeps_handle_hand_and_push) {
  for (const double delay : {0.0, 0.0025}) {
    SimulatedDeviceParameters late;
    late.translation.damping = 3;
    late.delay = delay;
    SimulatedHand simulated(late, period, 1, com, start);
    const Hand hand = simulated.hand();
    const double wall = (start * com).x();
    simulated.set_target(moved(start, Vec3(0.02, 0, 0)));
    const double before = (run(hand, 4000, 200, wall) * com).x() - wall;
    ASSERT_NEAR(before, 0.02 * 300 / (300 + 200), 1e-7);
    for (const double rate : {4000., 500., 1000.}) {
      simulated.set_period(1 / rate);
      for (int i = 0; i < 200; ++i) {
        const double depth = (run(hand, 1, 200, wall) * com).x() - wall;
        ASSERT_NEAR(depth, before, 1e-7) << rate << " Hz, tick " << i;
      }
    }
  }
}

/// As above, two springs balance: with each hand's own. No tick between jumps.
TEST(SimulatedHand, a_change_of_grip_in_contact_moves_the_handle_to_the_new_balance) {
  SimulatedDeviceParameters device;
  device.translation.damping = 3;
  SimulatedHand simulated(device, period, 1, com, start);
  const Hand hand = simulated.hand();
  const double wall = (start * com).x();
  simulated.set_target(moved(start, Vec3(0.02, 0, 0)));
  double before = (run(hand, 4000, 200, wall) * com).x();
  for (const double stiffness : {1000., 200.}) {
    device.translation.hand_stiffness = stiffness;
    device.translation.inertia = 0.4;
    simulated.set_parameters(device, period);
    for (int i = 0; i < 4000; ++i) {
      const double now = (run(hand, 1, 200, wall) * com).x();
      ASSERT_LT(std::abs(now - before), 2e-4) << "tick " << i;  // 0.2 m/s: no hand's jerk
      before = now;
    }
    EXPECT_NEAR(before - wall, 0.02 * stiffness / (stiffness + 200), 1e-7);
  }
  device.translation.inertia = 0;
  EXPECT_THROW(simulated.set_parameters(device, period), std::invalid_argument);
  EXPECT_NEAR((run(hand, 1, 200, wall) * com).x(), before, 1e-7) << "and all stays";
}

TEST(SimulatedHand, another_rate_on_the_way_keeps_the_velocity) {
  SimulatedHand simulated({}, period, 1, com, start);
  const Hand hand = simulated.hand();
  simulated.set_target(moved(start, Vec3(0.2, 0, 0)));
  const double x0 = run(hand, 100).p.x(), x1 = run(hand, 1).p.x();
  simulated.set_period(period / 10);
  const double x2 = run(hand, 1).p.x();
  EXPECT_NEAR((x2 - x1) / (period / 10), (x1 - x0) / period, 0.05 * std::abs(x1 - x0) / period);
}

TEST(SimulatedHand, a_rate_that_it_cannot_run_at_changes_nothing) {
  SimulatedDeviceParameters late;
  late.delay = 0.01;
  SimulatedHand simulated(late, period, 1, com, start);
  EXPECT_THROW(simulated.set_period(1e-4), std::invalid_argument) << "100 samples late";
  EXPECT_LT((run(simulated.hand(), 10).p - start.p).norm(), 1e-14);
}

/// How far the probe swings in a wall of stiffness k, after three seconds and three later, m.
struct Swing {
  double soon, later;
};
Swing swing_in_wall(double k) {
  SimulatedDeviceParameters bare;
  bare.translation.damping = 0.5;
  bare.translation.hand_stiffness = 20;
  bare.translation.hand_damping = 0;
  bare.translation.limit = 1e9;
  SimulatedHand simulated(bare, period, 1, com, start);
  const Hand hand = simulated.hand();
  const double wall = (start * com).x() - 0.002;  // inside from the start
  simulated.set_target(moved(start, Vec3(0.01, 0, 0)));
  const auto swing = [&] {
    double low = 1e9, high = -1e9;
    for (int i = 0; i < 200; ++i) {
      const double x = run(hand, 1, k, wall).p.x();
      low = std::min(low, x);
      high = std::max(high, x);
    }
    return high - low;
  };
  run(hand, 3000, k, wall);
  const double soon = swing();
  run(hand, 3000, k, wall);
  return {soon, swing()};
}

/// The limit of stability of a wall without a hand, m 0.1 kg, b 0.5 N·s/m, 1 kHz, no delay, is
/// 1000.8 N/m (the eigenvalues of the sampled loop). A light hand changes little. Below it the
/// swing dies away, by (b - K T/2)/2m = 0.75 a second; above it, it goes on from wall to air.
TEST(SimulatedHand, a_gain_too_high_buzzes_and_one_below_the_limit_comes_to_rest) {
  const Swing below = swing_in_wall(700), above = swing_in_wall(1500);
  EXPECT_LT(below.later, 0.2 * below.soon);
  EXPECT_GT(above.later, 0.5 * above.soon);
  EXPECT_GT(above.later, 10 * below.later);
}

// The power is the same at both ends: b v² with a v that is `scaling` times greater at the probe.
TEST(SimulatedHand, tells_what_the_device_is_like_as_felt_at_the_probe) {
  SimulatedDeviceParameters device;
  device.translation.damping = 2;
  device.translation.most_virtual_damping = 30;
  device.rotation.most_virtual_damping = 0.07;
  device.delay = 0.001;
  SimulatedHand simulated(device, period, 2, com, start);
  const std::optional<DeviceTraits> traits = simulated.hand().sample(period).device;
  ASSERT_TRUE(traits);
  EXPECT_EQ(traits->damping, 0.5);
  EXPECT_EQ(traits->max_damping, 7.5);
  EXPECT_EQ(traits->max_rotational_damping, 0.07);
  EXPECT_EQ(traits->delay, 0.001);
  EXPECT_EQ(traits->ratio, 0);
  EXPECT_EQ(traits->mass, device.translation.inertia / 4);
  EXPECT_EQ(traits->inertia, device.rotation.inertia);
  EXPECT_TRUE(traits->force);
}

TEST(SimulatedHand, scaling_and_place_change_without_a_jump) {
  SimulatedHand simulated({}, period, 1, com, start);
  const Hand hand = simulated.hand();
  run(hand, 10);
  simulated.set_target(moved(start, Vec3(0.05, 0, 0)));
  const Pose before = run(hand, 50);
  simulated.set_scaling(5);
  EXPECT_LT((hand.sample(period).X_FM.p - before.p).norm(), 2e-3);
  const Pose elsewhere = moved(start, Vec3(0, 0, 1));
  simulated.set_target(elsewhere);
  simulated.place(elsewhere);
  const Pose placed = run(hand, 100);
  EXPECT_LT((placed.p - elsewhere.p).norm(), 1e-12) << "at rest there";
}

/// A wall of 500 N/m at the start, into which the hand wants to go.
struct HandOnWall {
  SimulatedHand simulated{{}, period, 1, com, start};
  Hand hand = simulated.hand();
  Pose last = start;

  HandOnWall() { simulated.set_target(moved(start, Vec3(0.03, 0, 0))); }
  /// The greatest speed in so many ticks, m/s.
  double speed(int ticks) {
    double most = 0;
    for (int i = 0; i < ticks; ++i) {
      const Pose now = hand.sample(period).X_FM;
      const double in = (now.p - start.p).x();
      hand.render({.force = Vec3(in > 0 ? -500 * in : 0, 0, 0)});
      most = std::max(most, (now.p - last.p).norm() / period);
      last = now;
    }
    return most;
  }
};

TEST(SimulatedHand, a_change_of_scaling_in_contact_does_not_kick) {
  HandOnWall pressed;
  pressed.speed(2000);
  ASSERT_LT(pressed.speed(100), 1e-3) << "at rest in the wall";
  pressed.simulated.set_scaling(1);
  EXPECT_LT(pressed.speed(50), 1e-3) << "no change";
  // The hand follows the mouse, whose place is another one to it at another scaling: the handle
  // moves, and is not flung. As the hand's damper had it flung: 0.86 m/s.
  pressed.simulated.set_scaling(1.1);
  EXPECT_LT(pressed.speed(50), 0.2);
}

// As a connected device does: see HandSample.
TEST(SimulatedHand, another_scaling_is_told_once_and_keeps_the_hands_push) {
  constexpr double stiffness = 100;
  SimulatedDeviceParameters held;
  held.translation.hand_stiffness = stiffness;
  SimulatedHand simulated(held, period, 1, com, start);
  const Hand hand = simulated.hand();
  simulated.set_target(moved(start, Vec3(0.03, 0, 0)));
  HandSample last;
  for (int i = 0; i < 5000; ++i) {  // held off by as much as its spring pushes
    last = hand.sample(period);
    EXPECT_EQ(last.rescaled, 1);
    hand.render({.force = Vec3(-stiffness * 0.03, 0, 0)});
  }
  ASSERT_NEAR((last.X_FM.p - start.p).norm(), 0, 1e-3);
  simulated.set_scaling(0.25);
  simulated.set_target(moved(start, Vec3(0.03 * 0.25, 0, 0)));  // as far away from the handle
  for (int i = 0; i < 100; ++i) {
    const HandSample now = hand.sample(period);
    EXPECT_EQ(now.rescaled, i == 0 ? 0.25 : 1);
    EXPECT_LT((now.X_FM.p - last.X_FM.p).norm(), 1e-4) << i;
    hand.render({.force = Vec3(-stiffness * 0.03 / 0.25, 0, 0)});
  }
}

TEST(SimulatedHand, what_no_device_has_is_refused) {
  SimulatedDeviceParameters massless;
  massless.translation.inertia = 0;
  EXPECT_THROW(SimulatedHand(massless, period, 1, com, start), std::invalid_argument);
}

TEST(SimulatedHand, it_neither_allocates_nor_frees) {
  SimulatedHand simulated({}, period, 1, com, start);
  const Hand hand = simulated.hand();
  Pose at;
  simulated.set_period(period / 2);  // the servo's side of it comes with the next tick
  test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) {
    simulated.set_target(moved(start, Vec3(0.001 * i, 0, 0)));
    if (i == 50) simulated.set_scaling(2);
    if (i == 70) simulated.place(start);
    at = hand.sample(period).X_FM;
    hand.render({.force = Vec3(1, 0, 0)});
  }
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0U);
  EXPECT_TRUE(at.p.allFinite());
}

}  // namespace
}  // namespace sonde
