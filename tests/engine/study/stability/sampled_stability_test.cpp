// SPDX-License-Identifier: GPL-3.0-or-later
// References: the published points of the sampled wall (to the digits printed), Jury's criterion
// for the loop of two states worked out by hand, and the simulated device, which integrates by
// another formula and knows nothing of eigenvalues.
#include "engine/study/stability/sampled_stability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "engine/haptics/hand/simulated_device.hpp"

namespace sonde {
namespace {

struct Point {
  double damping, virtual_damping;
  double prompt, late;  ///< largest stable stiffness without delay, and with one sample of it, N/m
  double half_digit;    ///< of the last digit printed
};

// Zero-order hold, velocity by backward difference, T = 1 ms, m = 0.1 kg.
constexpr Point points[] = {{0.1, 0, 200.0, 66.7, 0.05},
                            {0.5, 0, 1000.8, 333.8, 0.05},
                            {0.5, 5, 10473, 3468, 0.5},
                            {2, 10, 21809, 7159, 0.5}};

TEST(SampledStability, reference_points_to_the_digits_printed) {
  for (const Point& p : points) {
    SampledAxis axis{.damping = p.damping, .virtual_damping = p.virtual_damping};
    EXPECT_NEAR(largest_stable_stiffness(axis), p.prompt, p.half_digit);
    axis.delay = axis.sample_time;
    EXPECT_NEAR(largest_stable_stiffness(axis), p.late, p.half_digit);
  }
}

/// The axis with every force, mass and damping in units that are `scale` times smaller.
SampledAxis scaled(const SampledAxis& axis, double scale) {
  return {axis.inertia * scale, axis.damping * scale, axis.virtual_damping * scale,
          axis.sample_time, axis.delay};
}

TEST(SampledStability, torque_is_the_same_with_the_inertia) {
  // A turn of one axis is a translation of the same equation: kg·m² for kg.
  for (const Point& p : points) {
    const SampledAxis axis{.damping = p.damping, .virtual_damping = p.virtual_damping};
    const double scale = 5e-4;  // 0.1 kg becomes 5e-5 kg·m²
    EXPECT_NEAR(largest_stable_stiffness(scaled(axis, scale)), p.prompt * scale,
                p.half_digit * scale);
  }
}

TEST(SampledStability, without_delay_or_virtual_damping_jury_says_the_same) {
  // z² + (G p − 1 − E) z + E + G q, with E = e^(−bT/m), the poles of x'' + a x' held over a sample:
  // stable up to where the last coefficient is 1 or z = −1 is a root, whichever is first.
  for (const double damping : {0.05, 0.5, 5.0, 50.0, 500.0}) {
    const SampledAxis axis{.inertia = 0.1, .damping = damping};
    const double a = damping / axis.inertia, T = axis.sample_time, E = std::exp(-a * T);
    const double p = (a * T - 1 + E) / (a * a * axis.inertia);
    const double q = (1 - E - a * T * E) / (a * a * axis.inertia);
    const double jury = std::min((1 - E) / q, 2 * (1 + E) / (p - q > 0 ? p - q : 1e-300));
    EXPECT_NEAR(largest_stable_stiffness(axis) / jury, 1, 2e-6) << damping;
  }
}

TEST(SampledStability, at_the_limit_the_radius_is_one_and_it_grows_beyond) {
  for (const double delay : {0.0, 0.0004, 0.001, 0.0027}) {
    const SampledAxis axis{.damping = 0.5, .virtual_damping = 1, .delay = delay};
    const double K = largest_stable_stiffness(axis);
    EXPECT_NEAR(spectral_radius(axis, K), 1, 1e-7);
    EXPECT_GT(spectral_radius(axis, 1.001 * K), 1 + 1e-6);
    for (int i = 1; i < 100; ++i) EXPECT_LT(spectral_radius(axis, K * i / 100), 1) << i;
  }
}

TEST(SampledStability, delays_between_samples_lie_between) {
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 30; ++i) {
    const SampledAxis axis{.damping = 0.5, .virtual_damping = 0.5, .delay = i * 1e-4};
    const double K = largest_stable_stiffness(axis);
    EXPECT_LT(K, last) << i;
    last = K;
  }
  // To either side of a whole sample the matrices differ in size, not in what they say.
  SampledAxis axis{.damping = 0.5, .virtual_damping = 5, .delay = 1e-3};
  const double whole = largest_stable_stiffness(axis);
  for (const double delay : {1e-3 - 1e-9, 1e-3 + 1e-9}) {
    axis.delay = delay;
    EXPECT_NEAR(largest_stable_stiffness(axis) / whole, 1, 1e-5);
  }
}

TEST(SampledStability, no_damping_holds_no_spring_and_too_much_virtual_damping_none) {
  EXPECT_EQ(largest_stable_stiffness({}), 0);
  EXPECT_EQ(largest_passive_stiffness({}), 0);
  // B alone is unstable from about m/T on.
  EXPECT_GT(largest_stable_stiffness({.virtual_damping = 50}), 0);
  EXPECT_EQ(largest_stable_stiffness({.virtual_damping = 300}), 0);
}

TEST(SampledStability, numbers_that_make_no_sense_are_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const SampledAxis& axis :
       {SampledAxis{.inertia = 0}, SampledAxis{.inertia = nan}, SampledAxis{.damping = -1},
        SampledAxis{.virtual_damping = -1}, SampledAxis{.sample_time = 0},
        SampledAxis{.delay = -1e-3}, SampledAxis{.delay = 2}}) {
    EXPECT_THROW(spectral_radius(axis, 100), std::invalid_argument);
    EXPECT_THROW(largest_stable_stiffness(axis), std::invalid_argument);
    EXPECT_THROW(largest_passive_stiffness(axis), std::invalid_argument);
  }
  EXPECT_THROW(spectral_radius({}, nan), std::invalid_argument);
}

// The loop itself, sample by sample, with a simulated device for the axis: pressed into a wall by a
// constant push, it swings about where wall and push balance.

struct Wall {
  SampledAxis axis;
  bool turning = false;  ///< the wall is one for rotations
};

SimulatedDevice device_of(const Wall& wall) {
  SimulatedDeviceParameters parameters;
  parameters.translation = {
      .inertia = wall.axis.inertia, .damping = wall.axis.damping, .limit = 1e6};
  parameters.rotation = parameters.translation;
  parameters.delay = wall.axis.delay;
  return {parameters, wall.axis.sample_time};
}

double coordinate(const SimulatedDevice& device, bool turning) {
  const Pose X = device.measured();
  return turning ? 2 * std::atan2(X.q.x(), X.q.w()) : X.p.x();
}

/// True where the swing about the balance grows: its largest in the last quarter of the run is
/// above that in the quarter before.
bool buzzes(const Wall& wall, double stiffness, int samples) {
  SimulatedDevice handle = device_of(wall);
  const double depth = 1e-3;  // of the balance; swings stay within the wall until they are as large
  const double push = stiffness * depth;
  handle.reset(wall.turning ? Pose{Quat(Eigen::AngleAxisd(depth, Vec3::UnitX())), Vec3::Zero()}
                            : Pose{Quat::Identity(), depth * Vec3::UnitX()});
  double before = depth, largest[2] = {0, 0};
  for (int k = 0; k < samples; ++k) {
    const double x = coordinate(handle, wall.turning);
    if (x < 0) return true;  // thrown out of the wall
    const double knock = k == 0 ? 0.2 * push : 0;
    const double F =
        stiffness * x + wall.axis.virtual_damping * (x - before) / wall.axis.sample_time;
    before = x;
    if (k >= samples / 2) {
      double& quarter = largest[k < samples / 4 * 3 ? 0 : 1];
      quarter = std::max(quarter, std::abs(x - depth));
    }
    Wrench command;
    (wall.turning ? command.torque : command.force).x() = push + knock - F;
    handle.step(command, {});
  }
  return largest[1] > largest[0];
}

double largest_quiet_stiffness(const Wall& wall, double low, double high) {
  const int samples = 20000;
  EXPECT_FALSE(buzzes(wall, low, samples));
  EXPECT_TRUE(buzzes(wall, high, samples));
  while (high - low > 1e-3 * high) {
    const double middle = (low + high) / 2;
    (buzzes(wall, middle, samples) ? high : low) = middle;
  }
  return (low + high) / 2;
}

TEST(SampledStability, the_simulated_loop_buzzes_where_the_eigenvalues_say) {
  double worst = 0;
  int cases = 0;
  for (const double mass : {0.05, 0.2})
    for (const double damping : {0.3, 2.0})
      for (const double virtual_damping : {0.0, 4.0})
        for (const double sample_time : {5e-4, 1e-3, 2e-3})
          for (const double delay : {0.0, 5e-4, 1e-3, 1.7e-3})
            for (const bool turning : {false, true}) {
              SampledAxis axis{mass, damping, virtual_damping, sample_time, delay};
              if (turning) axis = scaled(axis, 5e-4);
              const double K = largest_stable_stiffness(axis);
              EXPECT_LE(largest_passive_stiffness(axis), K * (1 + 1e-6));
              if (K == 0) {
                EXPECT_TRUE(buzzes({axis, turning}, 1e-3 * damping / sample_time, 20000));
                continue;
              }
              const double seen = largest_quiet_stiffness({axis, turning}, 0.9 * K, 1.1 * K);
              EXPECT_NEAR(seen / K, 1, 0.02)
                  << mass << ' ' << damping << ' ' << virtual_damping << ' ' << sample_time << ' '
                  << delay << ' ' << turning;
              worst = std::max(worst, std::abs(seen / K - 1));
              ++cases;
            }
  RecordProperty("worst", std::to_string(worst));
  RecordProperty("cases", cases);
  EXPECT_GT(cases, 150);
}

/// N·s/m: the damping that a device needs so that the wall is passive, by the theorem of Colgate
/// and Schenkel (1994), b > T/2 · Re[(1 − e^(−jθ)) H(e^(jθ))] / (1 − cos θ) at every θ = ωT from 0
/// to π, with the wall H(z) = (K + B (1 − z⁻¹)/T) z⁻ⁿ, late by n whole samples.
double needed_damping(double stiffness, double virtual_damping, double sample_time, int late) {
  constexpr int steps = 20000;
  double most = 0;
  for (int i = 1; i <= steps; ++i) {
    const double angle = std::numbers::pi * i / steps;
    const std::complex<double> back = std::polar(1.0, -angle);
    const std::complex<double> wall =
        (stiffness + virtual_damping * (1.0 - back) / sample_time) * std::pow(back, late);
    most = std::max(most, sample_time / 2 * ((1.0 - back) * wall).real() / (1 - std::cos(angle)));
  }
  return most;
}

double passive_by_the_theorem(const SampledAxis& axis, int late) {
  double low = 0, high = 1e7;
  for (int i = 0; i < 60; ++i) {
    const double k = (low + high) / 2;
    (needed_damping(k, axis.virtual_damping, axis.sample_time, late) < axis.damping ? low : high) =
        k;
  }
  return low;
}

TEST(SampledStability, the_passive_limit_is_that_of_the_theorem_or_below_it) {
  double least = 1;
  for (const double sample_time : {2.5e-4, 1e-3})
    for (const double damping : {0.5, 2.0, 10.0})
      for (const double share : {0.0, 0.2, 0.5, 0.9})
        for (const int late : {0, 1, 3}) {
          const SampledAxis axis{0.1, damping, share * damping, sample_time, late * sample_time};
          const double ratio = largest_passive_stiffness(axis) / passive_by_the_theorem(axis, late);
          if (share == 0 || late == 0) {
            EXPECT_NEAR(ratio, 1, 1e-6) << damping << ' ' << share << ' ' << late;
          }
          EXPECT_LE(ratio, 1 + 1e-6) << damping << ' ' << share << ' ' << late;
          least = std::min(least, ratio);
        }
  RecordProperty("least", std::to_string(least));
  // The manual's figures: both a virtual damping and a delay.
  EXPECT_NEAR(largest_passive_stiffness({0.1, 2, 1, 1e-3, 1e-3}), 667, 0.5);
  EXPECT_NEAR(passive_by_the_theorem({0.1, 2, 1, 1e-3, 1e-3}, 1), 1464, 0.5);
  // More virtual damping than the device's own leaves none passive.
  EXPECT_EQ(largest_passive_stiffness({0.1, 2, 2.1, 1e-3, 1e-3}), 0);
  EXPECT_LT(passive_by_the_theorem({0.1, 2, 2.1, 1e-3, 1e-3}, 1), 1e-6);
}

TEST(SampledStability, the_passive_limit_is_on_its_side) {
  for (const double damping : {0.1, 0.5, 2.0, 10.0})
    for (const double virtual_damping : {0.0, 0.2, 1.0})
      for (const double delay : {0.0, 3e-4, 1e-3, 2.5e-3, 5e-3}) {
        const SampledAxis axis{0.1, damping, virtual_damping, 1e-3, delay};
        const double passive = largest_passive_stiffness(axis);
        if (virtual_damping == 0) {
          EXPECT_DOUBLE_EQ(passive * (axis.sample_time / 2 + delay), damping);
        }
        EXPECT_LE(passive, largest_stable_stiffness(axis) * (1 + 1e-6)) << damping << ' ' << delay;
      }
}

}  // namespace
}  // namespace sonde
