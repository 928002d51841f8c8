// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/restricted/planar_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/error.hpp"
#include "tests/engine/penetration/overlapping_pose.hpp"
#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

// Reference: the distance to the nearest side, as seen along the normal. The clearance is at most
// 1e-4 of it.
TEST(PlanarSearch, a_box_slides_out_over_the_nearest_side_of_another) {
  const Pair pair(test::body(test::box({0.2, 0.3, 0.1})), test::body(test::box({0.5, 0.4, 0.7})));
  const Vec3 half(0.35, 0.35, 0.4), p(0.13, -0.04, 0.21);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      double least = 1;
      for (int k = 0; k < 3; ++k)
        if (k != axis) least = std::min(least, half[k] - std::abs(p[k]));
      const Separation found =
          planar_separation(pair, {Quat::Identity(), p}, sign * Vec3::Unit(axis), false, {});
      ASSERT_EQ(found.status, Status::penetrating) << found.reason;
      EXPECT_GE(found.depth, least);
      EXPECT_LE(found.depth, least * (1 + 2e-4));
      EXPECT_EQ(found.separated.p[axis], p[axis]);
      EXPECT_LT((found.separated.q.coeffs() - Quat::Identity().coeffs()).norm(), 1e-15);
      ASSERT_TRUE(found.lower_bound);
      EXPECT_LE(*found.lower_bound, least);
      EXPECT_GT(*found.lower_bound, 0);
    }
}

// Reference: exact predicates and winding numbers of all triangles, and σ by its definition.
TEST(PlanarSearch, its_pose_is_free_and_reached_in_the_plane) {
  std::mt19937_64 random(5);
  int turned_less = 0, found_some = 0;
  for (const auto& bodies : test::body_pairs(17)) {
    if (bodies.name == "far") continue;  // 1e6 m off, where a turn about the normal moves along it
    const Pair pair(bodies.a, bodies.b);
    const Pose X = test::overlapping_pose(random, bodies, 0.4);
    const Vec3 normal = test::random_rotation(random) * Vec3::UnitZ();
    const double R = bodies.a->mass.radius, size = R + bodies.b->mass.radius;
    double slid = 0;
    for (const bool turning : {false, true}) {
      StaticOptions options;
      options.want_lower_bound = false;
      const Separation found = planar_separation(pair, X, normal, turning, options);
      ASSERT_EQ(found.status, Status::penetrating) << bodies.name << found.reason;
      EXPECT_FALSE(found.lower_bound);
      EXPECT_TRUE(test::is_free(*bodies.a, *bodies.b, Transform(found.separated))) << bodies.name;
      EXPECT_NEAR(test::pose_distance(*bodies.a, X, found.separated), found.depth, 1e-9 * size);
      const Vec3 com = bodies.a->mass.com;
      EXPECT_NEAR(normal.dot(found.separated * com - X * com), 0, 1e-12 * size) << bodies.name;
      const Quat turn = found.separated.q * X.q.conjugate();
      EXPECT_LT(normal.cross(turn.vec()).norm(), 1e-12) << bodies.name;
      if (!turning) {
        EXPECT_LT(turn.vec().norm(), 1e-12);
        slid = found.depth;
        continue;
      }
      EXPECT_LE(found.depth, 1.05 * slid) << bodies.name;  // slides are among its motions
      turned_less += found.depth < 0.98 * slid;
      ++found_some;
    }
  }
  EXPECT_GT(found_some, 4);
  EXPECT_GT(turned_less, 0);
}

// Reference: the least over all turns of how far the lowest corner of a rod is in a wall then.
TEST(PlanarSearch, a_rod_turns_and_slides_out_by_the_least_of_both) {
  const double length = 0.3, thick = 0.04, height = 0.03, tilt = 0.35;
  const Pair pair(test::body(test::box({length, thick, 0.05})),
                  test::body(test::scaled_and_moved(test::box({4, 2, 4}), 1, Vec3(0, -1, 0))));
  const double inertia = (length * length + thick * thick) / 12;
  double least = 1;
  for (int i = -100000; i <= 100000; ++i) {
    const double turn = i * 1e-5, angle = tilt + turn;
    const double in = 0.5 * (length * std::abs(std::sin(angle)) + thick * std::cos(angle)) - height;
    least = std::min(
        least, std::pow(std::max(0.0, in), 2) + 4 * inertia * std::pow(std::sin(0.5 * turn), 2));
  }
  const Pose X{Quat(Eigen::AngleAxisd(tilt, Vec3::UnitZ())), Vec3(0.1, height, 0.2)};
  const Separation found = planar_separation(pair, X, Vec3::UnitZ(), true, {});
  ASSERT_EQ(found.status, Status::penetrating) << found.reason;
  EXPECT_GE(found.depth, std::sqrt(least) * (1 - 1e-6));  // the scan's step
  EXPECT_LE(found.depth, std::sqrt(least) * (1 + 3e-4));
}

TEST(PlanarSearch, tells_how_far_it_is_and_ends_when_it_is_told_to) {
  const auto cube = test::body(test::box({1, 1, 1}));
  const Pair pair(cube, cube);
  const Pose X{Quat::Identity(), {0.1, 0.2, 0.3}};
  std::vector<double> told;
  const auto note = [&](double share) {
    told.push_back(share);
    return true;
  };
  planar_separation(pair, X, Vec3::UnitZ(), true, {}, note);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_LE(told.back(), 1);
  EXPECT_LT(told.size(), static_cast<std::size_t>(StaticOptions().starts));  // they agreed
  EXPECT_THROW(planar_separation(pair, X, Vec3::UnitZ(), true, {}, [](double) { return false; }),
               Cancelled);
  // As many starts as are asked for, at most.
  told.clear();
  StaticOptions options;
  options.starts = 3;
  options.agreement = 100;
  planar_separation(pair, X, Vec3::UnitZ(), true, options, note);
  EXPECT_EQ(told.size(), 3u);
}

TEST(PlanarSearch, the_same_seed_gives_the_same_bits) {
  const auto knot = test::body(test::torus_knot(2, 3, 0.1, 0.04, 0.03, 20, 5));
  const Pair pair(knot, knot);
  const Pose X{Quat::Identity(), {0.01, 0.02, 0.03}};
  const Separation a = planar_separation(pair, X, Vec3::UnitX(), true, {});
  const Separation b = planar_separation(pair, X, Vec3::UnitX(), true, {});
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.separated.p, b.separated.p);
}

}  // namespace
}  // namespace sonde
