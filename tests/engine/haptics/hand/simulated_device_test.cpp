// SPDX-License-Identifier: GPL-3.0-or-later
// References: the textbook's closed forms of a mass, a damper and a spring (elementary functions,
// where the code takes a matrix exponential), and their frequency response.
#include "engine/haptics/hand/simulated_device.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include "tests/engine/haptics/hand/bare_device.hpp"
#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

using namespace test;

/// x(t) of m x'' + c x' + k x = F from rest at zero.
double step_response(double m, double c, double k, double F, double t) {
  if (k == 0 && c == 0) return F / m * t * t / 2;
  if (k == 0) return F / c * (t + m / c * std::expm1(-c / m * t));
  const double decay = c / (2 * m), square = k / m - decay * decay;
  if (std::abs(square) < 1e-9 * k / m) return F / k * (1 - std::exp(-decay * t) * (1 + decay * t));
  if (square > 0) {
    const double w = std::sqrt(square);
    return F / k * (1 - std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t)));
  }
  const double w = std::sqrt(-square), slow = -(k / m) / (decay + w), fast = -decay - w;
  return F / k * (1 + (fast * std::exp(slow * t) - slow * std::exp(fast * t)) / (slow - fast));
}

struct Springy {
  double mass, damping, hand_stiffness, hand_damping;
};
constexpr Springy springies[] = {
    {0.1, 0, 0, 0},       // free
    {0.1, 0.5, 0, 0},     // coasting
    {0.1, 0.5, 300, 2},   // swinging
    {0.1, 2, 1000, 18},   // just not swinging
    {0.1, 1, 300, 40},    // creeping
    {0.05, 0, 1e6, 0.1},  // a hand of steel
    {1, 0, 1, 1000},      // in treacle
};

TEST(SimulatedDevice, step_response_is_the_closed_form_at_any_rate) {
  for (const Springy& s : springies)
    for (const double sample_time : {1e-4, 1e-3, 1e-2}) {
      SimulatedDeviceParameters p = bare(s.mass);
      p.translation.damping = s.damping;
      p.translation.hand_stiffness = s.hand_stiffness;
      p.translation.hand_damping = s.hand_damping;
      SimulatedDevice device(p, sample_time);
      double largest = 0, error = 0;
      for (int k = 1; k <= 200; ++k) {
        device.step(force(2), {});
        const double x =
            step_response(s.mass, s.damping + s.hand_damping, s.hand_stiffness, 2, k * sample_time);
        largest = std::max(largest, std::abs(x));
        error = std::max(error, std::abs(device.state().X_WD.p.x() - x));
      }
      EXPECT_LT(error, 1e-9 * largest) << s.hand_stiffness << ' ' << sample_time;
    }
}

TEST(SimulatedDevice, torque_is_the_same_with_the_inertia) {
  for (const Springy& s : springies) {
    const double scale = 1e-3;  // kg·m² for kg
    SimulatedDeviceParameters p = bare();
    p.rotation.inertia = s.mass * scale;
    p.rotation.damping = s.damping * scale;
    p.rotation.hand_stiffness = s.hand_stiffness * scale;
    p.rotation.hand_damping = s.hand_damping * scale;
    SimulatedDevice device(p, T);
    for (int k = 1; k <= 200; ++k) {
      device.step(torque(2 * scale), {});
      const double x =
          step_response(s.mass, s.damping + s.hand_damping, s.hand_stiffness, 2, k * T);
      ASSERT_NEAR(angle_x(device), x, 1e-9) << s.hand_stiffness;
    }
  }
}

TEST(SimulatedDevice, a_command_acts_when_its_delay_is_over) {
  for (const double delay : {0.0, 0.3e-3, 1e-3, 2.7e-3, 64e-3}) {
    SimulatedDeviceParameters p = bare();
    p.translation.damping = 0.5;
    p.delay = delay;
    SimulatedDevice device(p, T);
    for (int k = 1; k <= 200; ++k) {
      device.step(force(2), {});
      const double t = std::max(0.0, k * T - delay);
      ASSERT_NEAR(device.state().X_WD.p.x(), step_response(0.1, 0.5, 0, 2, t), 1e-12) << delay;
    }
  }
}

TEST(SimulatedDevice, the_last_command_is_held_and_none_is_lost) {
  // Without damping the speed is the impulse given so far, whatever the order.
  SimulatedDeviceParameters p = bare();
  p.delay = 2.25e-3;
  SimulatedDevice device(p, T);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  double impulse = 0;
  for (int k = 0; k < 500; ++k) {
    const double F = any(random);
    impulse += F * T;
    device.step(force(F), {});
  }
  for (int k = 0; k < 3; ++k) device.step({}, {});
  EXPECT_NEAR(device.state().velocity.x(), impulse / 0.1, 1e-12);
}

TEST(SimulatedDevice, motors_give_no_more_than_they_have) {
  SimulatedDeviceParameters p = bare();
  p.translation.limit = 3;
  p.rotation.limit = 0;  // a device without torque
  SimulatedDevice device(p, T);
  Wrench command = force(300, 400, 0);
  command.torque = {1, 2, 3};
  device.step(command, {});
  EXPECT_LT((device.motors().force - Vec3(1.8, 2.4, 0)).norm(), 1e-15);
  EXPECT_EQ(device.motors().torque, Vec3::Zero());
  EXPECT_TRUE(device.motors().saturated);
  EXPECT_NEAR(device.state().velocity.norm(), 3 * T / 0.1, 1e-15);
  EXPECT_EQ(device.state().spin, Vec3::Zero());
  command.force.x() = std::numeric_limits<double>::quiet_NaN();
  device.step(command, {});
  EXPECT_EQ(device.motors().force, Vec3::Zero());
  EXPECT_TRUE(device.state().X_WD.p.allFinite());
}

TEST(SimulatedDevice, encoders_round_to_their_step) {
  SimulatedDeviceParameters p = bare();
  p.translation.resolution = 3e-5;
  p.rotation.resolution = 2e-3;
  SimulatedDevice device(p, T);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 axis = Vec3(any(random), any(random), any(random)).normalized();
    Pose X = turned(3 * any(random), axis);
    X.p = 0.1 * Vec3(any(random), any(random), any(random));
    device.reset(X);
    const Pose seen = device.measured();
    EXPECT_LE((seen.p - X.p).cwiseAbs().maxCoeff(), 1.5e-5 * (1 + 1e-9));
    for (int k = 0; k < 3; ++k) {
      const double steps = seen.p[k] / 3e-5;
      EXPECT_NEAR(steps, std::round(steps), 1e-9);
    }
    EXPECT_LE(seen.q.angularDistance(X.q), std::sqrt(3.0) * 1e-3 * (1 + 1e-6));
  }
  device.reset(turned(0.0109));
  EXPECT_NEAR(device.measured().q.angularDistance(turned(0.010).q), 0, 1e-8);
  device.reset(turned(0.0111));
  EXPECT_NEAR(device.measured().q.angularDistance(turned(0.012).q), 0, 1e-8);
}

TEST(SimulatedDevice, the_hand_follows_its_target) {
  // The frequency response of target to handle: (b_h s + k) / (m s² + (b + b_h) s + k).
  SimulatedDeviceParameters p = bare();
  p.translation = {
      .inertia = 0.1, .damping = 0.3, .limit = 1e9, .hand_stiffness = 300, .hand_damping = 5};
  p.rotation = {
      .inertia = 5e-5, .damping = 2e-4, .limit = 1e9, .hand_stiffness = 0.5, .hand_damping = 0.01};
  for (const double hertz : {0.5, 2.0, 8.0}) {
    const double w = 2 * std::numbers::pi * hertz;
    const auto gain = [&](const HandleMotion& h) {
      const std::complex<double> s(0, w);
      return (h.hand_damping * s + h.hand_stiffness) /
             (h.inertia * s * s + (h.damping + h.hand_damping) * s + h.hand_stiffness);
    };
    const std::complex<double> x = 0.05 * gain(p.translation), turn = 0.3 * gain(p.rotation);
    SimulatedDevice device(p, T);
    for (int k = 1; k <= 5000; ++k) {
      const double t = k * T;
      Pose target = turned(0.3 * std::sin(w * t));
      target.p.x() = 0.05 * std::sin(w * t);
      device.step({}, target);
      if (k < 2000) continue;  // until the start is forgotten
      const std::complex<double> phase = std::polar(1.0, w * t);
      // The target is straight between samples: (w T)²/12 of it at most.
      const double straight = std::pow(w * T, 2) / 6;
      ASSERT_NEAR(device.state().X_WD.p.x(), (x * phase).imag(), 0.05 * straight + 1e-12);
      ASSERT_NEAR(angle_x(device), (turn * phase).imag(), 0.3 * straight + 1e-12);
    }
  }
}

TEST(SimulatedDevice, friction_and_damping_hold_the_hand_back) {
  // At a constant speed u the hand pulls with b u + friction: it is ahead by that over its
  // stiffness.
  SimulatedDeviceParameters p = bare();
  p.translation = {.inertia = 0.1,
                   .damping = 2,
                   .friction = 0.25,
                   .limit = 1e9,
                   .hand_stiffness = 300,
                   .hand_damping = 5};
  SimulatedDevice device(p, T);
  const double u = 0.1;
  double x = 0;
  for (int k = 1; k <= 5000; ++k) device.step({}, at(x = k * T * u));
  EXPECT_NEAR(x - device.state().X_WD.p.x(), (2 * u + 0.25) / 300, 1e-9);
}

TEST(SimulatedDevice, no_gain_is_too_high_for_the_simulation) {
  // A wall a million times too stiff shakes the handle; the motors' limit bounds what it can do.
  SimulatedDeviceParameters p;
  p.translation = {.inertia = 0.1,
                   .damping = 0.5,
                   .friction = 0.05,
                   .resolution = 1e-5,
                   .limit = 8,
                   .hand_stiffness = 300,
                   .hand_damping = 5};
  p.delay = T;
  SimulatedDevice device(p, T);
  double speed = 0, depth = 0;
  for (int k = 0; k < 20000; ++k) {
    const double x = device.measured().p.x();
    device.step(force(-1e9 * std::max(0.0, x)), at(0.002));
    speed = std::max(speed, std::abs(device.state().velocity.x()));
    depth = std::max(depth, std::abs(device.state().X_WD.p.x()));
  }
  EXPECT_GT(speed, 0.05);  // it buzzes
  EXPECT_LT(speed, 8 / 5.5 * 2);
  EXPECT_LT(depth, 8.0 / 300 * 2);

  // A hand that is far too stiff and damped only holds it fast.
  for (const double damping : {0.0, 1e6}) {
    SimulatedDeviceParameters stiff = bare();
    stiff.translation.hand_stiffness = 1e8;
    stiff.translation.hand_damping = damping;
    SimulatedDevice held(stiff, T);
    for (int k = 1; k <= 20000; ++k) held.step(force(10), at(k * 1e-5));
    EXPECT_NEAR(held.state().X_WD.p.x(), 0.2, 1e-3);
  }
}

TEST(SimulatedDevice, a_push_is_a_force_at_once_and_without_limit) {
  SimulatedDeviceParameters p = bare();
  p.translation.limit = 1;
  p.delay = 5e-3;
  SimulatedDevice device(p, T);
  for (int k = 1; k <= 3; ++k) {
    device.step({}, {}, force(2));
    EXPECT_NEAR(device.state().X_WD.p.x(), step_response(0.1, 0, 0, 2, k * T), 1e-15);
  }
  EXPECT_EQ(device.motors().force, Vec3::Zero());
  device.step({}, {}, torque(1e-3));
  EXPECT_NEAR(device.state().spin.x(), 1e-3 * T / 5e-5, 1e-12);
}

TEST(SimulatedDevice, same_input_same_bits_and_no_allocation) {
  SimulatedDeviceParameters p;
  p.translation.friction = 0.1;
  p.rotation.resolution = 1e-3;
  p.delay = 1.5e-3;
  const auto run = [&](bool count) {
    SimulatedDevice device(p, T);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> any(-1, 1);
    test::AllocationCounter counter;
    for (int k = 0; k < 1000; ++k) {
      Wrench w = force(any(random), any(random), any(random));
      w.torque = 0.1 * w.force;
      Pose hand = turned(any(random), Vec3(1, 1, 0).normalized());
      hand.p = 0.01 * w.force;
      device.step(w, hand);
      (void)device.measured();
    }
    counter.stop();
    if (count) {
      EXPECT_EQ(counter.allocations(), 0u);
    }
    return device.state();
  };
  const HandleState a = run(true), b = run(false);
  EXPECT_EQ(a.X_WD.p, b.X_WD.p);
  EXPECT_EQ(a.X_WD.q.coeffs(), b.X_WD.q.coeffs());
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.spin, b.spin);
  EXPECT_GT(a.velocity.norm(), 0);
}

TEST(SimulatedDevice, what_no_device_has_is_refused) {
  using Change = std::function<void(SimulatedDeviceParameters&)>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Change changes[] = {[](auto& p) { p.translation.inertia = 0; },
                            [](auto& p) { p.rotation.inertia = -1; },
                            [&](auto& p) { p.rotation.damping = nan; },
                            [](auto& p) { p.translation.friction = -1; },
                            [](auto& p) { p.translation.resolution = -1; },
                            [](auto& p) { p.rotation.limit = -1; },
                            [](auto& p) { p.delay = -1e-3; },
                            [](auto& p) { p.delay = 65e-3; },
                            [](auto& p) { p.rotation.hand_stiffness = 1e9; }};
  for (const Change& change : changes) {
    SimulatedDeviceParameters p;
    change(p);
    EXPECT_THROW(SimulatedDevice(p, T), std::invalid_argument);
  }
  EXPECT_THROW(SimulatedDevice({}, 0), std::invalid_argument);
  EXPECT_THROW(SimulatedDevice({}, nan), std::invalid_argument);
  EXPECT_NO_THROW(SimulatedDevice({}, T));
}

}  // namespace
}  // namespace sonde
