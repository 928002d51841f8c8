// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/descent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/penetration/search/coherent.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/joints.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Reference: all pairs of triangles, for the pose that is reached. From free poses on the rim of
// the chart, |v| = largest_v, where a step that leads out of the chart may have nothing left of it.
TEST(Descent, stays_within_the_chart_and_free_from_its_rim) {
  std::mt19937_64 random(11);
  int runs = 0, stayed = 0;
  for (const auto& pair : test::body_pairs(51)) {
    const MassProperties& mass = pair.a->mass;
    if (!(mass.inertia.minCoeff() > 0)) continue;
    Descent descent(*pair.a, *pair.b, Method::pdg);
    for (int i = 0; i < 40; ++i) {
      const Chart chart(mass, test::random_pose(random, *pair.a, *pair.b, 0.8));
      const Vec3 v = Chart::largest_v * test::random_in_ball(random, 1).normalized();
      Vec6 y;
      y.head<3>() = 2 * mass.inertia.cwiseSqrt().cwiseProduct(v);
      y.tail<3>() = test::random_in_ball(random, 1.5 * mass.radius);
      if (test::any_pair_meets(*pair.a, *pair.b, Transform(chart.pose(y)))) continue;
      descent.forget();
      const Descent::Outcome out = descent.run(chart, y, {}, 0, Deadline{});
      ASSERT_TRUE(out.y.allFinite()) << pair.name;
      EXPECT_LE(out.y.norm(), y.norm() * (1 + 1e-12)) << pair.name;
      EXPECT_LE(chart.v(out.y).norm(), Chart::largest_v * (1 + 1e-9)) << pair.name;
      EXPECT_FALSE(test::any_pair_meets(*pair.a, *pair.b, Transform(chart.pose(out.y))))
          << pair.name;
      ++runs;
      const bool at_rim = chart.v(out.y).norm() > (1 - 1e-9) * Chart::largest_v;
      if (at_rim && !out.converged) {
        EXPECT_GT(out.limited, 0) << pair.name;
      }
      stayed += at_rim && !out.converged;
    }
  }
  EXPECT_GT(runs, 50);
  EXPECT_GT(stayed, 0) << "no run was held at the rim";
}

// Reference: the same run without a limit, which goes on.
TEST(Descent, what_has_come_far_gets_a_limit_and_says_so) {
  std::mt19937_64 random(12);
  int limited = 0;
  for (const auto& pair : test::body_pairs(52)) {
    const MassProperties& mass = pair.a->mass;
    if (!(mass.inertia.minCoeff() > 0)) continue;
    Descent descent(*pair.a, *pair.b, Method::pdg);
    for (int i = 0; i < 20; ++i) {
      const Chart chart(mass, test::random_pose(random, *pair.a, *pair.b, 0.8));
      Vec6 y = Vec6::Zero();
      y.tail<3>() = 1.5 * mass.radius * test::random_in_ball(random, 1).normalized();
      if (test::any_pair_meets(*pair.a, *pair.b, Transform(chart.pose(y)))) continue;
      descent.forget();
      Effort unlimited;
      const Descent::Outcome whole = descent.run(chart, y, {}, 0, unlimited);
      EXPECT_FALSE(unlimited.is_limited()) << pair.name;
      DescentGoal goal;
      goal.far = 1e-3 * mass.radius;
      goal.work_of_fall = 1;
      descent.forget();
      Effort effort;
      const Descent::Outcome cut = descent.run(chart, y, goal, 0, effort);
      EXPECT_FALSE(test::any_pair_meets(*pair.a, *pair.b, Transform(chart.pose(cut.y))));
      EXPECT_LE(cut.iterations, whole.iterations) << pair.name;
      if ((cut.y - y).norm() <= goal.far) continue;
      EXPECT_TRUE(effort.is_limited()) << pair.name;
      if (whole.iterations < 3) continue;
      EXPECT_LT(cut.iterations, whole.iterations) << pair.name;
      EXPECT_FALSE(cut.converged) << pair.name;
      ++limited;
    }
  }
  EXPECT_GT(limited, 10);
}

// A nut that has jammed on its bolt gets free when the device is half a turn ahead, and unscrews
// the other way. Reference: the same run without a limit, which goes all that way at once.
TEST(Descent, a_run_whose_paths_take_too_much_gets_a_limit_and_says_so) {
  constexpr std::int64_t work = 450'000;
  int long_runs = 0, unlimited_runs = 0;
  for (const test::FittedScene& scene : test::joint_scenes()) {
    if (!scene.name.ends_with("jammed")) continue;
    const auto probe = test::body(scene.probe), fixed = test::body(scene.fixed);
    CoherentSolver solver({probe, fixed});
    Descent descent(*probe, *fixed, Method::pdg, {}, Descent::gap_of_follower);
    DescentGoal goal;
    goal.work_of_fall = work;
    goal.far = 0.25 * probe->mass.radius;
    DescentGoal follower = goal;  // not held off by its contacts: only far from its start
    follower.held_off = 1e3 * probe->mass.radius;
    const std::vector<Pose> path = test::fitted_path(scene.path, 3000);
    solver.reset(path.front());
    for (const Pose& device : path) {
      const Pose from = solver.last().separated;
      const Separation& found = solver.tick(device);
      if (found.converged || found.limited == 0) continue;
      const Chart chart(probe->mass, device);
      const Vec6 y = chart.coordinates(from);
      const auto run = [&](const DescentGoal& of, Effort& effort) {
        descent.forget();
        return descent.run(chart, y, of, 1e-3 * y.norm(), effort);
      };
      Effort whole, cut;
      const std::int64_t before = whole.left();
      run({}, whole);
      EXPECT_FALSE(whole.is_limited());
      if (before - whole.left() < 3 * work) continue;
      const Descent::Outcome out = run(goal, cut);
      // A run may also be long without one path that takes too much: then it is the same run.
      if (!cut.is_limited()) {
        EXPECT_EQ(cut.left(), whole.left()) << scene.name;
        continue;
      }
      EXPECT_FALSE(out.converged) << scene.name;
      EXPECT_GT(out.limited, 0) << scene.name;
      Effort followed;
      const Descent::Outcome on = run(follower, followed);
      if ((on.y - y).norm() < goal.far) {
        EXPECT_FALSE(followed.is_limited()) << scene.name;
        ++unlimited_runs;
      }
      // The list and the path before the limit may have spent more by themselves.
      EXPECT_GT(cut.left(), -work) << scene.name;
      ++long_runs;
    }
  }
  EXPECT_GT(long_runs, 3);
  EXPECT_GT(unlimited_runs, 0);
}

// A turn is cut into steps of one length, which are no series.
TEST(Descent, a_long_turn_away_from_everything_takes_few_steps) {
  const auto probe = test::body(test::box({0.02, 0.03, 0.05})),
             fixed = test::body(test::box({0.3, 0.3, 0.1}));
  for (int degrees = 100; degrees <= 140; degrees += 5) {
    CoherentSolver solver({probe, fixed});
    solver.reset({Quat::Identity(), Vec3(0, 0, 0.5)});
    const double half = 0.5 * degrees / 180.0 * std::numbers::pi;
    const Vec3 axis = std::sin(half) * Vec3(1, 2, 3).normalized();
    const Pose turned{Quat(std::cos(half), axis.x(), axis.y(), axis.z()), Vec3(0.1, 0, 0.5)};
    const Separation& there = solver.tick(turned);
    EXPECT_TRUE(there.converged) << degrees;
    EXPECT_EQ(there.status, Status::separated) << degrees;
    EXPECT_LE(there.iterations, 8) << degrees;
  }
}

}  // namespace
}  // namespace sonde
