// SPDX-License-Identifier: GPL-3.0-or-later
// What takes energy from the handle and what does not. Reference: the balance of energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/haptics/hand/simulated_device.hpp"
#include "tests/engine/haptics/hand/bare_device.hpp"

namespace sonde {
namespace {

using namespace test;

TEST(SimulatedDevice, without_losses_the_hands_spring_keeps_the_energy) {
  SimulatedDeviceParameters p = bare();
  p.translation.hand_stiffness = 300;
  p.rotation.hand_stiffness = 0.5;
  SimulatedDevice device(p, T);
  const Wrench push = [] {
    Wrench w = force(3, -1, 2);
    w.torque = {0.05, 0, 0};
    return w;
  }();
  for (int k = 0; k < 20; ++k) device.step(push, {});
  const auto energy = [&] {
    const HandleState& s = device.state();
    return Vec3(0.05 * s.velocity.squaredNorm(), 150 * s.X_WD.p.squaredNorm(),
                2.5e-5 * s.spin.squaredNorm() + 0.25 * std::pow(angle_x(device), 2));
  };
  const Vec3 start = energy();
  for (int k = 0; k < 100000; ++k) device.step({}, {});
  const Vec3 end = energy();
  EXPECT_NEAR((end[0] + end[1]) / (start[0] + start[1]), 1, 1e-9);
  EXPECT_NEAR(end[2] / start[2], 1, 1e-9);
}

TEST(SimulatedDevice, a_tumbling_handle_keeps_its_energy_as_the_rate_grows) {
  // Where the axis of the turn changes the step is not exact: it loses a little, and gains nothing
  // to speak of.
  SimulatedDeviceParameters p = bare();
  p.rotation.hand_stiffness = 0.5;
  const auto worst_change = [&](double sample_time) {
    SimulatedDevice device(p, sample_time, turned(0.8, Vec3(1, 2, 3).normalized()));
    const auto energy = [&] {
      const double angle = device.state().X_WD.q.angularDistance(Quat::Identity());
      return 2.5e-5 * device.state().spin.squaredNorm() + 0.25 * angle * angle;
    };
    for (int k = 0; k < 10; ++k) device.step(torque(0.2, -0.1, 0.05), {});
    const double start = energy();
    double loss = 0;
    for (int k = 0; k < 1 / sample_time; ++k) {
      device.step({}, {});
      EXPECT_LT(energy(), start * 1.02);
      loss = std::max(loss, 1 - energy() / start);
    }
    return loss;
  };
  const double coarse = worst_change(1e-3);
  EXPECT_LT(coarse, 0.2);
  EXPECT_LT(worst_change(2.5e-4), coarse / 3);
}

TEST(SimulatedDevice, left_alone_it_loses_energy_until_it_rests) {
  SimulatedDeviceParameters p = bare();
  p.translation = {.inertia = 0.1,
                   .damping = 0.2,
                   .friction = 0.1,
                   .limit = 1e9,
                   .hand_stiffness = 300,
                   .hand_damping = 0.5};
  p.rotation = {.inertia = 5e-5,
                .damping = 1e-4,
                .friction = 1e-3,
                .limit = 1e9,
                .hand_stiffness = 0.5,
                .hand_damping = 1e-4};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int run = 0; run < 20; ++run) {
    SimulatedDevice device(p, T);
    for (int k = 0; k < 30; ++k) {
      Wrench w = force(5 * any(random), 5 * any(random), 5 * any(random));
      w.torque.x() = 0.2 * any(random);
      device.step(w, {});
    }
    for (int k = 0; k < 3000; ++k) {
      const HandleState before = device.state();
      const double angle_before = angle_x(device);
      device.step({}, {});
      const HandleState& now = device.state();
      // Friction is constant over a step, also over one in which the motion stops or turns back:
      // there it can push, with no more than its own work.
      const auto ends = [](const Vec3& old_rate, const Vec3& rate) {
        return rate.dot(old_rate) <= 1e-9 * old_rate.squaredNorm();
      };
      const double gain = 0.05 * (now.velocity.squaredNorm() - before.velocity.squaredNorm()) +
                          150 * (now.X_WD.p.squaredNorm() - before.X_WD.p.squaredNorm());
      const bool back = ends(before.velocity, now.velocity);
      ASSERT_LE(gain, back ? 0.1 * (now.X_WD.p - before.X_WD.p).norm() + 1e-18 : 1e-18);
      const double angle = angle_x(device);
      const double gain_turn = 2.5e-5 * (now.spin.squaredNorm() - before.spin.squaredNorm()) +
                               0.25 * (angle * angle - angle_before * angle_before);
      const bool turns_back = ends(before.spin, now.spin);
      ASSERT_LE(gain_turn, turns_back ? 1e-3 * std::abs(angle - angle_before) + 1e-18 : 1e-18);
    }
    // At rest, not just slow, and where friction can hold the spring.
    EXPECT_LT(device.state().velocity.norm(), 1e-12);
    EXPECT_LT(device.state().spin.norm(), 1e-12);
    EXPECT_LE(300 * device.state().X_WD.p.norm(), 0.1 * (1 + 1e-6));
    EXPECT_LE(0.5 * std::abs(angle_x(device)), 1e-3 * (1 + 1e-6));
  }
}

TEST(SimulatedDevice, friction_takes_the_same_off_every_swing) {
  // The swings of a mass on a spring shrink by 2 F/k from one turning point to the next.
  for (const double sample_time : {1e-3, 1e-4}) {
    SimulatedDeviceParameters p = bare();
    p.translation.hand_stiffness = 300;
    p.translation.friction = 0.1;
    SimulatedDevice device(p, sample_time);
    const Pose hand = at(0.02);  // far away by the next sample: a step of the target
    double furthest = 0.02, last = 0;
    int turns = 0;
    device.step({}, hand);
    for (int k = 0; turns < 8; ++k) {
      ASSERT_LT(k, 10000000);
      const double before = device.state().velocity.x();
      device.step({}, hand);
      if (before * device.state().velocity.x() > 0) continue;
      const double reach = std::abs(device.state().X_WD.p.x() - 0.02);
      if (++turns > 1) {
        EXPECT_NEAR(last - reach, 2 * 0.1 / 300, 0.1 * 2 * 0.1 / 300) << turns;
      }
      last = reach;
      furthest = std::max(furthest, reach);
    }
    EXPECT_EQ(furthest, 0.02);
  }
}

TEST(SimulatedDevice, friction_holds_below_its_limit_and_stops_beyond) {
  SimulatedDeviceParameters p = bare();
  p.translation.friction = 0.3;
  p.rotation.friction = 2e-3;
  SimulatedDevice device(p, T, at(0.1, 0.2, 0.3));
  Wrench push = force(0.17, 0.17, 0.17);  // 0.294 N
  push.torque = {1.1e-3, 1.1e-3, 1.1e-3};
  for (int k = 0; k < 10000; ++k) device.step(push, at(0.1, 0.2, 0.3));
  EXPECT_EQ(device.state().X_WD.p, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(device.state().X_WD.q.vec(), Vec3::Zero());

  // Pushed harder it slides by what is left of the push; let go, it slides as far as its energy
  // goes.
  device.reset({});
  for (int k = 0; k < 100; ++k) device.step(force(0.6, 0.8), {});
  const double speed = (1.0 - 0.3) / 0.1 * 100 * T;
  EXPECT_LT((device.state().velocity - speed * Vec3(0.6, 0.8, 0)).norm(), 1e-12);
  const Vec3 from = device.state().X_WD.p;
  for (int k = 0; k < 1000; ++k) device.step({}, {});
  EXPECT_EQ(device.state().velocity, Vec3::Zero());
  EXPECT_NEAR((device.state().X_WD.p - from).norm(), speed * speed * 0.1 / (2 * 0.3), speed * T);
}

}  // namespace
}  // namespace sonde
