// SPDX-License-Identifier: GPL-3.0-or-later
// References: the gradient of the spring's energy, which the same Jacobian makes of y; differences
// of y along paths; the definition of a Rayleigh function, whose power is −b |ẏ|².
#include "engine/haptics/coupling/object_damper.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/geometry/random.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/sensitivity/wrench_derivative.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double sway_tick = 1e-3, sway_damping = 3;

/// A path that sways slowly, deep in the contact: sums of sines of random phase.
class Sway {
 public:
  Sway(std::uint64_t seed, const Vec3& at, double reach) : at_(at), reach_(reach) {
    Random random(seed);
    for (double& phase : phases_) phase = random.uniform(0, 6.28);
    for (double& rate : rates_) rate = random.uniform(1, 9);
  }
  Pose at(double t) const {
    Vec6 x;
    for (Eigen::Index i = 0; i < 6; ++i) {
      const auto n = static_cast<std::size_t>(i);
      x[i] = std::sin(phases_[n] + rates_[n] * t);
    }
    return {rotation_by(0.3 * Vec3(x.tail<3>())), at_ + reach_ * Vec3(x.head<3>())};
  }

 private:
  Vec3 at_;
  double reach_;
  double phases_[6], rates_[6];
};

struct SwayedPair {
  const char* name;
  Pair pair;
  Vec3 at;  // where the path sways
  double reach;
};

std::vector<SwayedPair> swayed_pairs() {
  const auto block = test::body(test::box({0.3, 0.3, 0.1}));
  return {
      {"box, block", {test::body(test::box({0.02, 0.03, 0.05})), block}, {0, 0, 0.066}, 0.004},
      {"box, ball",
       {test::body(test::box({0.02, 0.03, 0.05})), test::body(test::sphere(0.03, 24, 32))},
       {0, 0.01, 0.045},
       0.006},
      {"torus, torus",
       {test::body(test::torus(0.04, 0.015, 16, 10)), test::body(test::torus(0.06, 0.02, 16, 10))},
       {0.01, 0, 0.024},
       0.004}};
}

Vec6 motion_between(const MassProperties& mass, const Pose& from, const Pose& to) {
  const SeparationMotion m = separation_motion(mass, from, to);
  Vec6 out;
  out << m.t, m.theta;
  return out;
}

/// A separation with its Jacobian, where it has one on all sides.
struct SwayedTick {
  Separation s;
  Vec6 y = Vec6::Zero();
  Mat6 Y = Mat6::Zero();
  bool smooth = false;
};

SwayedTick swayed_tick(const Pair& pair, const Separation& s) {
  SwayedTick out{.s = s};
  if (s.status != Status::penetrating || !s.converged || s.jumped) return out;
  const WrenchDerivative d = wrench_derivative(pair, s);
  out.smooth = d.sides == WrenchDerivative::Sides::all;
  out.y = Chart(pair.probe().mass, s.device).coordinates(s.separated);
  out.Y = separation_jacobian(pair.probe().mass, s.device, s.separated, d.d_separated);
  return out;
}

TEST(ObjectDamper, its_jacobian_makes_the_spring_of_the_separation) {
  for (const SwayedPair& each : swayed_pairs()) {
    const MassProperties& mass = each.pair.probe().mass;
    CoherentSolver solver(each.pair);
    solver.reset({Quat::Identity(), each.at + Vec3(0, 0, 0.2)});
    int looked = 0;
    double worst = 0;
    const Sway sway(5, each.at, each.reach);
    for (int i = 0; i < 2000; ++i) {
      const SwayedTick seen = swayed_tick(each.pair, solver.tick(sway.at(i * sway_tick)));
      if (!seen.smooth) continue;
      ++looked;
      const Wrench spring = object_norm_wrench(mass, seen.s.device, seen.s.separated, 1);
      const Vec6 got = -seen.Y.transpose() * seen.y;
      // Torques weighed as forces at the arm of the probe.
      worst = std::max(worst, (got.head<3>() - spring.force).norm() / spring.force.norm());
      worst = std::max(
          worst, (got.tail<3>() - spring.torque).norm() / (spring.force.norm() * mass.radius));
    }
    EXPECT_GT(looked, 500) << each.name;
    // What stands off by the clearance, 1e-4 of the depth.
    EXPECT_LT(worst, 0.02) << each.name;
    RecordProperty(each.name, std::to_string(worst));
  }
}

struct SwayWork {
  double damper = 0, wanted = 0, most_given = 0;  // J, on the hand; b |Δy|²/T
  double plain_given = 0;                         // of a force b ẏ that ignores how Q follows
  int ticks = 0;
};

SwayWork work_along(const SwayedPair& each, std::uint64_t seed) {
  const MassProperties& mass = each.pair.probe().mass;
  CoherentSolver solver(each.pair);
  solver.reset({Quat::Identity(), each.at + Vec3(0, 0, 0.2)});
  const Sway sway(seed, each.at, each.reach);
  SwayWork out;
  SwayedTick before = swayed_tick(each.pair, solver.tick(sway.at(0)));
  for (int i = 1; i < 2500; ++i) {
    const SwayedTick now = swayed_tick(each.pair, solver.tick(sway.at(i * sway_tick)));
    if (before.smooth && now.smooth) {
      const Vec6 rate = (now.y - before.y) / sway_tick;
      const Vec6 moved = motion_between(mass, before.s.device, now.s.device);
      const Wrench w = object_damper((before.Y + now.Y) / 2, rate, sway_damping);
      const double done = w.force.dot(moved.head<3>()) + w.torque.dot(moved.tail<3>());
      out.damper += done;
      out.wanted -= sway_damping * sway_tick * rate.squaredNorm();
      out.most_given = std::max(out.most_given, done);
      out.plain_given += std::max(0.0, sway_damping * rate.tail<3>().dot(moved.head<3>()));
      ++out.ticks;
    }
    before = now;
  }
  return out;
}

TEST(ObjectDamper, takes_energy_out_on_random_paths) {
  for (const SwayedPair& each : swayed_pairs())
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      const SwayWork work = work_along(each, seed);
      EXPECT_GT(work.ticks, 500) << each.name;
      EXPECT_LT(work.damper, 0) << each.name;
      // Where a contact passes to another feature between two ticks, the mean of both is not exact.
      EXPECT_NEAR(work.damper / work.wanted, 1, 0.05) << each.name << ' ' << seed;
      EXPECT_LE(work.most_given, 0.01 * std::abs(work.wanted)) << each.name << ' ' << seed;
    }
}

// Why it is not the force b ẏ: round a ball the separation turns faster than the device goes.
TEST(ObjectDamper, a_damper_that_ignores_how_the_separation_follows_gives_energy) {
  const SwayWork work = work_along(swayed_pairs()[1], 1);
  EXPECT_GT(work.plain_given, 0.01 * std::abs(work.wanted));
}

}  // namespace
}  // namespace sonde
