// SPDX-License-Identifier: GPL-3.0-or-later
// One axis against a wall through the real engine: a box pressed into a large box. Reference: the
// eigenvalues of the sampled wall (sampled_stability.hpp), which know nothing of meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "engine/study/stability/press_and_hold.hpp"
#include "engine/study/stability/sampled_stability.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double half_wall = 0.1, pressed_depth = 2e-3;

/// What does not move in the axis that is studied.
constexpr HandleMotion immobile{.inertia = 1e3, .damping = 1e5, .limit = 1e6};

struct WallCase {
  SampledAxis axis;
  bool turning;
  std::shared_ptr<const Body> probe;
};

/// A cube that only moves up and down, or a bar that only turns.
WallCase wall_case(SampledAxis axis, bool turning) {
  if (turning) {  // kg·m² for kg, and the same of all that resists
    for (double* x : {&axis.inertia, &axis.damping, &axis.virtual_damping}) *x *= 5e-4;
    return {axis, true, test::body(test::box({0.2, 0.02, 0.02}))};
  }
  return {axis, false, test::body(test::box({0.05, 0.05, 0.05}))};
}

Coupling coupling(const WallCase& wall, double stiffness) {
  Coupling c;
  c.max_force = c.max_torque = 1e6;
  if (wall.axis.virtual_damping == 0) {
    c.k = wall.turning ? stiffness / wall.probe->mass.inertia[2] : stiffness;
    return c;
  }
  c.mode = Coupling::Mode::classic;
  c.k_t = wall.turning ? 1 : stiffness;
  c.k_r = wall.turning ? stiffness : 0;
  c.b_t = wall.turning ? 0 : wall.axis.virtual_damping;
  c.b_r = wall.turning ? wall.axis.virtual_damping : 0;
  return c;
}

/// Pressed in to `pressed_depth`, at rest there; then a knock of a few ticks.
Press press(const WallCase& wall, const Coupling& c, double stiffness) {
  const double half = wall.turning ? 0.01 : 0.025;
  const double k = c.mode == Coupling::Mode::object ? c.k : c.k_t;
  Press out;
  out.X_FM = {Quat::Identity(), {0, 0, half_wall + half - pressed_depth}};
  out.push.force = {0, 0, -k * pressed_depth};
  if (wall.turning) out.push.torque = {0, stiffness * 2e-4, 0};
  out.rise_time = wall.axis.sample_time;
  out.settle_time = 0.01;
  out.knock_time = 2 * wall.axis.sample_time;
  out.knock = 0.2;
  out.window_time = 3;
  out.decay = 0.98;
  out.quiet_speed = 1e-7;
  return out;
}

bool stable(const WallCase& wall, const std::shared_ptr<const Body>& fixed, double stiffness) {
  ClosedLoopSetup setup{{wall.probe, fixed},   Method::pdg, coupling(wall, stiffness), {},
                        wall.axis.sample_time, {}};
  const HandleMotion moving{
      .inertia = wall.axis.inertia, .damping = wall.axis.damping, .limit = 1e6};
  setup.device.translation = wall.turning ? immobile : moving;
  setup.device.rotation = wall.turning ? moving : immobile;
  setup.device.delay = wall.axis.delay;
  ClosedLoop loop(setup);
  const HoldReport report = press_and_hold(loop, press(wall, setup.coupling, stiffness));
  EXPECT_EQ(report.failures, 0);
  return report.stable;
}

std::vector<WallCase> grid() {
  std::vector<WallCase> out;
  for (const double mass : {0.05, 0.2})
    for (const double damping : {0.3, 2.0})
      for (const double virtual_damping : {0.0, 4.0})
        for (const double sample_time : {5e-4, 1e-3, 2e-3})
          for (const double delay : {0.0, 5e-4, 1e-3, 1.7e-3})
            for (const bool turning : {false, true})
              out.push_back(
                  wall_case({mass, damping, virtual_damping, sample_time, delay}, turning));
  return out;
}

/// Quiet 2 % below what the eigenvalues say and not 2 % above, and passive below both.
void expect_theory(const WallCase& wall) {
  static const auto fixed = test::body(test::box({1, 1, 2 * half_wall}));
  SCOPED_TRACE(testing::Message() << wall.axis.inertia << ' ' << wall.axis.damping << ' '
                                  << wall.axis.virtual_damping << ' ' << wall.axis.sample_time
                                  << ' ' << wall.axis.delay << ' ' << wall.turning);
  const double K = largest_stable_stiffness(wall.axis);
  if (K == 0) return;
  EXPECT_TRUE(stable(wall, fixed, 0.98 * K));
  EXPECT_FALSE(stable(wall, fixed, 1.02 * K));
  const double passive = largest_passive_stiffness(wall.axis);
  EXPECT_LE(passive, K * (1 + 1e-6));
  if (passive > 0 && passive < 0.98 * K) {
    EXPECT_TRUE(stable(wall, fixed, passive));
  }
}

TEST(WallTheory, the_engine_agrees_with_the_eigenvalues_within_two_percent) {
  std::vector<WallCase> cases = grid();
  std::mt19937 random(6);
  std::shuffle(cases.begin(), cases.end(), random);
  cases.resize(16);
  for (const WallCase& wall : cases) expect_theory(wall);
}

TEST(WallTheory, the_reference_points_through_the_engine) {
  // Zero-order hold, T = 1 ms, m = 0.1 kg: b, B, N/m without delay and with one sample of it.
  for (const auto& [b, B, prompt, late] :
       {std::array{0.1, 0.0, 200.0, 66.7}, std::array{0.5, 0.0, 1000.8, 333.8},
        std::array{0.5, 5.0, 10473.0, 3468.0}, std::array{2.0, 10.0, 21809.0, 7159.0}})
    for (const double delay : {0.0, 1e-3}) {
      const WallCase wall = wall_case({0.1, b, B, 1e-3, delay}, false);
      const auto fixed = test::body(test::box({1, 1, 2 * half_wall}));
      const double K = delay == 0 ? prompt : late;
      EXPECT_TRUE(stable(wall, fixed, 0.98 * K)) << b << ' ' << B << ' ' << delay;
      EXPECT_FALSE(stable(wall, fixed, 1.02 * K)) << b << ' ' << B << ' ' << delay;
    }
}

TEST(WallTheory, Full_the_whole_grid) {
  for (const WallCase& wall : grid()) expect_theory(wall);
}

}  // namespace
}  // namespace sonde
