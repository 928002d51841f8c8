// SPDX-License-Identifier: GPL-3.0-or-later
// References: the energy balance of the simulated device, and the passivity condition of Colgate
// and Schenkel with a delay.
#include "engine/haptics/safety/passivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/study/stability/sampled_stability.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double sample_time = 1e-3;

MassProperties mass() {
  MassProperties m;
  m.inertia = Vec3(4e-4, 5e-4, 6e-4);
  m.radius = 0.03;
  return m;
}

/// A wall, free for z > 0.
Wrench wall(const Pose& X, double k) {
  Wrench out;
  if (X.p.z() < 0) out.force.z() = -k * X.p.z();
  return out;
}

SimulatedDeviceParameters device(double damping, double delay, double hand) {
  SimulatedDeviceParameters p;
  p.translation = {
      .inertia = 0.1, .damping = damping, .limit = 1e4, .hand_stiffness = hand, .hand_damping = 0};
  p.rotation.limit = 1e4;
  p.delay = delay;
  return p;
}

struct Outcome {
  double kinetic = 0;    ///< J, of the handle: the largest of the last half
  double amplitude = 0;  ///< m
  HandEnergy energy;
};

/// A handle that falls on the wall and is pulled into it by the hand's spring.
Outcome against_wall(const SimulatedDeviceParameters& parameters, double k, bool control,
                     int ticks) {
  SimulatedDevice device(parameters, sample_time, {Quat::Identity(), Vec3(0, 0, 0.002)});
  PassivitySettings settings{.control = control,
                             .max_damping = 50,
                             .device_damping = parameters.translation.damping,
                             .delay = parameters.delay};
  Passivity passivity(mass(), settings, sample_time);
  passivity.restart(device.measured());
  Outcome out;
  for (int i = 0; i < ticks; ++i) {
    const Pose X = device.measured();
    passivity.observe(X, sample_time);
    const Wrench wrench = passivity.control(wall(X, k));
    passivity.rendered(wrench);
    device.step(wrench, {Quat::Identity(), Vec3(0, 0, -0.002)});
    if (i < ticks / 2) continue;
    const HandleState& s = device.state();
    out.kinetic =
        std::max(out.kinetic, 0.5 * parameters.translation.inertia * s.velocity.squaredNorm());
    out.amplitude = std::max(out.amplitude, std::abs(s.X_WD.p.z()));
  }
  out.energy = passivity.energy();
  return out;
}

// With nothing but the loop to do work on the handle, what it gains is what the loop has given.
TEST(Passivity, the_work_observed_is_the_energy_that_the_handle_gains) {
  for (const double delay : {0.0, 0.001, 0.003}) {
    SimulatedDevice handle(device(0, delay, 0), sample_time,
                           {Quat::Identity(), Vec3(0, 0, -0.003)});
    Passivity passivity(mass(), {.control = false, .delay = delay}, sample_time);
    passivity.restart(handle.measured());
    double most = 0;
    for (int i = 0; i < 400; ++i) {
      const Pose X = handle.measured();
      passivity.observe(X, sample_time);
      const double kinetic = 0.5 * 0.1 * handle.state().velocity.squaredNorm();
      ASSERT_NEAR(passivity.energy().given, kinetic, 1e-9 + 1e-9 * kinetic) << delay << ' ' << i;
      most = std::max(most, kinetic);
      Wrench wrench;
      wrench.force = -300 * X.p;
      wrench = passivity.control(wrench);
      passivity.rendered(wrench);
      handle.step(wrench, {});
    }
    EXPECT_GT(most, 1e-3);
  }
}

TEST(Passivity, turning_against_a_torque_is_work_too) {
  Passivity passivity(mass(), {}, sample_time);
  passivity.restart({});
  Wrench wrench;
  wrench.torque = Vec3(0, 0.2, 0);
  passivity.rendered(wrench);
  const Quat q(Eigen::AngleAxisd(-0.1, Vec3::UnitY()));
  passivity.observe({q, Vec3(0.3, 0, 0)}, sample_time);
  EXPECT_NEAR(passivity.energy().given, -0.02, 1e-12);
}

TEST(Passivity, the_controller_does_nothing_where_no_energy_is_given) {
  const double b = 2, k = 0.5 * b / sample_time;  // half of what is passive
  const Outcome with = against_wall(device(b, 0, 100), k, true, 4000);
  const Outcome without = against_wall(device(b, 0, 100), k, false, 4000);
  EXPECT_GT(without.energy.given, 0);  // sampling gives some, and the device's damping takes it
  EXPECT_LE(without.energy.excess, 1e-12);
  EXPECT_EQ(with.energy.dissipated, 0);
  EXPECT_EQ(with.amplitude, without.amplitude);
}

TEST(Passivity, a_wall_too_stiff_buzzes_without_the_controller_and_not_with_it) {
  for (const double delay : {0.0, 0.001}) {
    const double b = 0.5, k = 3000;
    const SimulatedDeviceParameters parameters = device(b, delay, 300);
    ASSERT_GT(k,
              2 * largest_passive_stiffness(
                      {.inertia = 0.1, .damping = b, .sample_time = sample_time, .delay = delay}));
    const Outcome without = against_wall(parameters, k, false, 6000);
    const Outcome with = against_wall(parameters, k, true, 6000);
    EXPECT_GT(without.energy.given, 20 * std::abs(with.energy.given)) << delay;
    EXPECT_GT(without.kinetic, 20 * with.kinetic) << delay;
    EXPECT_GT(without.amplitude, 2 * with.amplitude) << delay;
    EXPECT_GT(with.energy.dissipated, 0);
  }
}

// b > K(T/2 + t_d), with the device's own damping alone.
TEST(Passivity, the_wall_gives_no_energy_below_the_stiffness_of_the_condition_with_its_delay) {
  for (const double delay : {0.0, 0.001, 0.002}) {
    const double b = 1;
    const double limit = b / (sample_time / 2 + delay);
    EXPECT_NEAR(limit,
                largest_passive_stiffness(
                    {.inertia = 0.1, .damping = b, .sample_time = sample_time, .delay = delay}),
                1e-9 * limit);
    const auto settles = [&](double k) {
      return against_wall(device(b, delay, 300), k, false, 20000).kinetic < 1e-9;
    };
    EXPECT_TRUE(settles(0.8 * limit)) << delay;
    EXPECT_FALSE(settles(4 * limit)) << delay;
  }
}

TEST(Passivity, what_a_contact_took_does_not_pay_for_the_next) {
  Passivity passivity(mass(), {.control = false}, sample_time);
  passivity.restart({});
  const auto at = [](double z) { return Pose{Quat::Identity(), Vec3(0, 0, z)}; };
  const auto push = [&](double z, double force) {
    passivity.observe(at(z), sample_time);
    Wrench w;
    w.force.z() = force;
    passivity.rendered(passivity.control(w));
  };
  push(0, 2);
  push(-0.01, 0);  // 20 mJ into the wall
  EXPECT_NEAR(passivity.energy().excess, -0.02, 1e-12);
  push(0, 0);
  push(0, 1);
  push(0.001, 1);
  EXPECT_NEAR(passivity.energy().excess, 0.001, 1e-12);
  EXPECT_NEAR(passivity.energy().given, -0.019, 1e-12);
}

/// A mouse, a path: control() is for what a force moves.
TEST(Passivity, a_contact_is_forgotten_where_nothing_is_controlled) {
  Passivity passivity(mass(), {.control = true}, sample_time);
  passivity.restart({});
  Wrench push;
  push.force.z() = 2;
  const auto tick = [&](double z, const Wrench& w) {
    passivity.observe({Quat::Identity(), Vec3(0, 0, z)}, sample_time);
    passivity.rendered(w);
  };
  tick(0, push);
  tick(-0.01, push);
  EXPECT_NEAR(passivity.energy().excess, -0.02, 1e-12);
  for (int i = 0; i < 3; ++i) tick(-0.01, Wrench{});
  EXPECT_EQ(passivity.energy().excess, 0);
}

TEST(Passivity, the_controller_only_ever_brakes_and_within_its_damping) {
  std::mt19937_64 random(5);
  Passivity passivity(mass(), {.control = true, .max_damping = 3}, sample_time);
  Pose X;
  passivity.restart(X);
  int braked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 step = test::random_in_ball(random, 1e-4), turn = test::random_in_ball(random, 1e-3);
    X.p += step;
    X.q = (Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * X.q).normalized();
    passivity.observe(X, sample_time);
    Wrench wanted;
    wanted.force = test::random_in_ball(random, 5);
    wanted.torque = test::random_in_ball(random, 0.05);
    const Wrench got = passivity.control(wanted);
    passivity.rendered(got);
    const double power =
        (got.force - wanted.force).dot(step) + (got.torque - wanted.torque).dot(turn);
    EXPECT_LE(power, 1e-15);
    EXPECT_LE((got.force - wanted.force).norm(), 3 * step.norm() / sample_time * (1 + 1e-9));
    braked += power < 0;
  }
  EXPECT_GT(braked, 100);
}

// The reference is the force that was taken off, over the speed; and the torque, over the spin.
TEST(Passivity, no_more_damping_is_taken_than_the_device_bears) {
  const MassProperties m = mass();
  const auto damped = [&](const std::optional<DeviceTraits>& device) {
    Passivity passivity(m, {.control = true, .max_damping = 3}, sample_time);
    passivity.set_device(device);
    passivity.restart({});
    Wrench push;
    push.force.z() = 1e6;  // far more energy than any damping takes back
    passivity.rendered(push);
    const double turn = 1e-3;
    passivity.observe({Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ())), Vec3(0, 0, 1e-4)},
                      sample_time);
    const Wrench got = passivity.control(push);
    return std::pair((push.force.z() - got.force.z()) / (1e-4 / sample_time),
                     -got.torque.z() / (turn / sample_time));
  };
  EXPECT_NEAR(damped({}).first, 3, 1e-6) << "nothing known: the settings'";
  EXPECT_NEAR(damped(DeviceTraits{}).first, 3, 1e-6);
  EXPECT_NEAR(damped(DeviceTraits{.ratio = 2}).first, 3.0 / 4, 1e-6) << "as felt by the hand";
  EXPECT_NEAR(damped(DeviceTraits{.max_damping = 30}).first, 30, 1e-6);
  // Turns: α Î, along the axis of the largest Î.
  const double most = 0.25 * 30 * m.inertia.z();
  const auto [force, torque] =
      damped(DeviceTraits{.max_damping = 30, .max_rotational_damping = most});
  EXPECT_NEAR(torque, most, 1e-9);
  EXPECT_NEAR(force, 30 * 0.25, 1e-6);
}

// Reference: F·x, less b v² dt of what the mechanism is known to take.
TEST(Passivity, damping_that_is_assumed_is_not_counted_on) {
  const auto excess = [](bool known) {
    Passivity passivity(mass(), {}, sample_time);
    passivity.set_device(DeviceTraits{.damping = 2, .known = known});
    passivity.restart({});
    Wrench push;
    push.force.z() = 3;
    passivity.rendered(push);
    passivity.observe({Quat::Identity(), Vec3(0, 0, 1e-4)}, sample_time);
    return passivity.energy().excess;
  };
  EXPECT_NEAR(excess(true), 3e-4 - 2 * 1e-8 / sample_time, 1e-12);
  EXPECT_NEAR(excess(false), 3e-4, 1e-12);
}

TEST(Passivity, a_device_that_is_put_away_is_forgotten) {
  Passivity passivity(mass(), {.control = true, .max_damping = 3}, sample_time);
  const auto largest = [&] {
    passivity.restart({});
    Wrench push;
    push.force.z() = 1e6;
    passivity.rendered(push);
    passivity.observe({Quat::Identity(), Vec3(0, 0, 1e-4)}, sample_time);
    passivity.control(push);
    return passivity.energy().damping;
  };
  passivity.set_device(DeviceTraits{.max_damping = 30});
  EXPECT_NEAR(largest(), 30, 1e-9);
  passivity.set_device({});
  EXPECT_NEAR(largest(), 3, 1e-9);
}

TEST(Passivity, allocates_nothing) {
  Passivity passivity(mass(), {.control = true}, sample_time);
  passivity.restart({});
  test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) {
    const Pose X{Quat::Identity(), Vec3(0, 0, -1e-4 * (i % 10))};
    passivity.observe(X, sample_time);
    passivity.rendered(passivity.control(wall(X, 1e4)));
  }
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
}

}  // namespace
}  // namespace sonde
