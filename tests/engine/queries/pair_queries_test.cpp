// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/queries/pair_queries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "engine/body/body.hpp"
#include "engine/queries/body_queries.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The largest coordinate that a query computes with, m.
double size_of(const test::BodyPair& pair, const Pose& X) {
  double size = X.p.cwiseAbs().maxCoeff();
  for (const auto* body : {&*pair.a, &*pair.b})
    for (const Vec3& x : body->soup.vertices) size = std::max(size, x.cwiseAbs().maxCoeff());
  return size;
}

/// The motion of sweep(), from its words: the centre of mass along a line, the turn by slerp.
Pose between(const Body& probe, const Pose& from, const Pose& to, double s) {
  const Quat q = from.q.slerp(s, to.q);
  const Vec3 com = (1 - s) * Vec3(from * probe.mass.com) + s * Vec3(to * probe.mass.com);
  return {q, com - q * probe.mass.com};
}

// Reference: exact predicates on every pair of triangles, and every vertex asked whether it is
// inside.
TEST(PairQueries, bodies_touch_where_any_two_triangles_do) {
  std::mt19937_64 random(1);
  for (const test::BodyPair& bodies : test::body_pairs(21)) {
    const Pair pair(bodies.a, bodies.b);
    int touching = 0;
    for (int i = 0; i < 60; ++i) {
      const Pose X = test::random_pose(random, *bodies.a, *bodies.b, 1.2);
      const bool expected = !test::is_free(*bodies.a, *bodies.b, Transform(X));
      EXPECT_EQ(touch(pair, X), expected) << bodies.name << " " << i;
      touching += expected;
    }
    EXPECT_GT(touching, 3) << bodies.name;
    EXPECT_LT(touching, 57) << bodies.name;
  }
}

// Reference: the least distance over every pair of triangles.
TEST(PairQueries, the_distance_is_the_least_of_all_pairs_of_triangles_and_its_points_have_it) {
  std::mt19937_64 random(2);
  for (const test::BodyPair& bodies : test::body_pairs(22)) {
    const Pair pair(bodies.a, bodies.b);
    for (int i = 0; i < 40; ++i) {
      const Pose X = test::random_pose(random, *bodies.a, *bodies.b, 1.6);
      const Clearance found = distance(pair, X);
      const double rounding = 1e-14 * size_of(bodies, X);
      ASSERT_EQ(found.overlapping, touch(pair, X)) << bodies.name << " " << i;
      if (found.overlapping) {
        EXPECT_EQ(found.distance, 0);
        continue;
      }
      const double expected = test::least_distance_of_pairs(*bodies.a, *bodies.b, Transform(X));
      EXPECT_NEAR(found.distance, expected, rounding) << bodies.name << " " << i;
      EXPECT_NEAR((found.on_probe - found.on_fixed).norm(), found.distance, rounding);
      EXPECT_LT(nearest_point(*bodies.b, found.on_fixed).distance, rounding);
      EXPECT_LT(nearest_point(*bodies.a, inverse(X) * found.on_probe).distance, 4 * rounding);
    }
  }
}

TEST(PairQueries, one_within_the_other_overlaps_though_no_triangles_meet) {
  const Pair pair(test::body(test::box({0.01, 0.01, 0.01})), test::body(test::box({1, 1, 1})));
  const Pose X{Quat::Identity(), Vec3(0.2, 0, 0)};
  EXPECT_TRUE(touch(pair, X));
  const Clearance found = distance(pair, X);
  EXPECT_TRUE(found.overlapping);
  EXPECT_EQ(found.distance, 0);
  EXPECT_NEAR((found.on_probe - found.on_fixed).norm(), 0.5 - 0.205, 1e-14) << "of the surfaces";
  const auto hollow = test::body(test::box({1, 1, 1}), Model::surface);
  EXPECT_FALSE(touch(Pair(test::body(test::box({0.01, 0.01, 0.01})), hollow), X));
}

// Reference: exact predicates (touch), on faces that meet, and are some roundings or more apart; at
// any distance from the origin, where rounding decides which way the query goes.
TEST(PairQueries, the_distance_overlaps_exactly_where_bodies_touch) {
  for (const double size : {1e-7, 0.1, 1e3})
    for (const double away : {0.0, 1.0, 1e3}) {
      PolygonSoup fixed = test::box({size, size, size});
      for (Vec3& x : fixed.points) x.y() += away;
      const Pair pair(test::body(test::box({size, size, size})), test::body(std::move(fixed)));
      for (int i = -40; i <= 40; ++i) {
        const double off = i * std::abs(i) * 1e-16 * size;
        const Pose X{Quat::Identity(), Vec3(size + off, 0.1 * size + away, 0.2 * size)};
        EXPECT_EQ(distance(pair, X).overlapping, touch(pair, X)) << size << ' ' << away << ' ' << i;
      }
    }
}

// Reference: a box slides onto a face: its way less the gap.
TEST(PairQueries, a_box_that_slides_to_a_wall_is_free_up_to_the_gap) {
  for (const double scale : {1e-4, 1.0, 1e3}) {
    const auto box = test::body(test::box(scale * Vec3(0.02, 0.03, 0.05)));
    const Pair pair(box, test::body(test::box(scale * Vec3(0.1, 1, 1))));
    const double gap = 0.037 * scale, way = 0.2 * scale;
    const Pose from{Quat::Identity(), Vec3(0.06 * scale + gap, 0.01 * scale, 0)};
    const Pose to{Quat::Identity(), from.p - Vec3(way, 0, 0)};
    const SweptPath path = sweep(pair, from, to);
    EXPECT_TRUE(path.hit);
    EXPECT_FALSE(path.overlapping);
    EXPECT_LE(path.free, gap / way);
    EXPECT_NEAR(path.free, gap / way, 1e-8);
    EXPECT_NEAR(path.contact.normal.x(), 1, 1e-6);
    EXPECT_NEAR(path.contact.on_fixed.x(), 0.05 * scale, 1e-9 * scale);
    EXPECT_FALSE(touch(pair, path.X_FM));
    const SweptPath away = sweep(pair, from, {Quat::Identity(), from.p + Vec3(way, 0, 0)});
    EXPECT_FALSE(away.hit);
    EXPECT_EQ(away.free, 1);
  }
}

// Reference: the corner of a rod that turns about its middle is L sin θ + h cos θ below it.
TEST(PairQueries, a_rod_that_turns_onto_a_plate_is_free_up_to_the_angle_of_its_corner) {
  const double L = 0.2, h = 0.01, height = 0.15;
  const auto rod = test::body(test::box({2 * L, 0.02, 2 * h}));
  const Pair pair(rod, test::body(test::box({2, 2, 0.1})));
  const Pose from{Quat::Identity(), Vec3(0, 0, 0.05 + height)};
  const double meets = std::asin(height / std::hypot(L, h)) - std::atan2(h, L);
  for (const double turn : {0.9, 1.5, 2.5, 3.1}) {
    const Pose to{Quat(Eigen::AngleAxisd(turn, Vec3::UnitY())), from.p};
    const SweptPath path = sweep(pair, from, to);
    ASSERT_TRUE(path.hit) << turn;
    EXPECT_LE(path.free, meets / turn * (1 + 1e-12)) << turn;
    EXPECT_NEAR(path.free, meets / turn, 1e-7) << turn;
    EXPECT_NEAR(std::abs(path.contact.on_probe.x()), L * std::cos(meets) - h * std::sin(meets),
                1e-6);
  }
  const Pose above{Quat::Identity(), Vec3(0, 0, 0.05 + 0.3)};
  EXPECT_FALSE(sweep(pair, above, {Quat(Eigen::AngleAxisd(3.0, Vec3::UnitY())), above.p}).hit);
}

// Reference: poses of the motion by its words (slerp), asked one by one whether they touch; and the
// distance where it ends.
TEST(PairQueries, all_poses_up_to_the_end_are_free_and_there_the_bodies_nearly_touch) {
  std::mt19937_64 random(3);
  int hits = 0, open = 0;
  for (const test::BodyPair& bodies : test::body_pairs(23)) {
    const Pair pair(bodies.a, bodies.b);
    for (int i = 0; i < 40; ++i) {
      const Pose from = test::random_pose(random, *bodies.a, *bodies.b, 2.5);
      const Pose to = test::random_pose(random, *bodies.a, *bodies.b, 2.5);
      const SweptPath path = sweep(pair, from, to);
      ASSERT_EQ(path.overlapping, touch(pair, from));
      if (path.overlapping) continue;
      for (int k = 0; k < 50; ++k)
        EXPECT_FALSE(touch(pair, between(*bodies.a, from, to, path.free * k / 50)))
            << bodies.name << " " << i;
      EXPECT_FALSE(touch(pair, path.X_FM));
      if (!path.hit) {
        EXPECT_EQ(path.free, 1);
        ++open;
        continue;
      }
      ++hits;
      const double rounding = 128 * 2.3e-16 * 3 * size_of(bodies, from);
      EXPECT_LE(distance(pair, path.X_FM).distance, 4e-9 * bodies.a->mass.radius + 4 * rounding)
          << bodies.name << " " << i;
      EXPECT_LE(path.contact.gap, 4e-9 * bodies.a->mass.radius + 4 * rounding);
    }
  }
  EXPECT_GT(hits, 30);
  EXPECT_GT(open, 30);
}

// Reference: there is no way past a sheet, however thin and however fast.
TEST(PairQueries, nothing_passes_through_a_sheet) {
  PolygonSoup sheet{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2, 3}}};
  const Pair pair(test::body(test::box({0.01, 0.01, 0.01})), test::body(sheet));
  const Pose from{Quat::Identity(), Vec3(0.1, 0.2, 500)}, to{Quat::Identity(), Vec3(0, 0.1, -500)};
  const SweptPath path = sweep(pair, from, to);
  EXPECT_TRUE(path.hit);
  EXPECT_NEAR(path.free, 0.499995, 1e-9);
}

TEST(PairQueries, a_motion_that_begins_in_an_overlap_says_so) {
  const Pair pair(test::body(test::box({1, 1, 1})), test::body(test::box({1, 1, 1})));
  const SweptPath path = sweep(pair, {}, {Quat::Identity(), Vec3(5, 0, 0)});
  EXPECT_TRUE(path.overlapping);
  EXPECT_TRUE(path.hit);
  EXPECT_EQ(path.free, 0);
}

TEST(PairQueries, a_quaternion_counts_by_its_direction) {
  const Pair pair(test::body(test::box({1, 1, 1})), test::body(test::box({1, 1, 1})));
  Quat q(Eigen::AngleAxisd(0.3, Vec3::UnitX()));
  const Pose unit{q, Vec3(2, 0, 0)};
  q.coeffs() *= 3;
  const Pose longer{q, Vec3(2, 0, 0)};
  EXPECT_NEAR(distance(pair, longer).distance, distance(pair, unit).distance, 1e-15);
}

TEST(PairQueries, what_is_no_pose_is_refused_with_the_reason) {
  const Pair pair(test::body(test::box({1, 1, 1})), test::body(test::box({1, 1, 1})));
  const Pose good{Quat::Identity(), Vec3(2, 0, 0)};
  for (const Pose& bad :
       {Pose{Quat::Identity(), Vec3(nan, 0, 0)}, Pose{Quat(nan, 0, 0, 0), Vec3(2, 0, 0)},
        Pose{Quat(0, 0, 0, 0), Vec3(2, 0, 0)}, Pose{Quat(1e160, 0, 0, 0), Vec3(2, 0, 0)}}) {
    EXPECT_THROW(touch(pair, bad), InputError);
    EXPECT_THROW(distance(pair, bad), InputError);
    EXPECT_THROW(sweep(pair, bad, good), InputError);
    EXPECT_THROW(sweep(pair, good, bad), InputError);
  }
  const Pose lost{Quat::Identity(), Vec3(1e200, 0, 0)};
  EXPECT_FALSE(touch(pair, lost)) << "far, but apart";
  EXPECT_THROW(sweep(pair, good, lost), InputError);
  EXPECT_THROW(sweep(pair, good, {Quat::Identity(), Vec3(1e20, 0, 0)}), InputError);
  EXPECT_FALSE(sweep(pair, good, {Quat::Identity(), Vec3(1e9, 0, 0)}).hit);
  for (const double far : {1e3, 1e9, 1e20, 1e150, 1e200, 1e300})
    EXPECT_NEAR(distance(pair, {Quat::Identity(), Vec3(far, 0, 0)}).distance / far, 1 - 1 / far,
                1e-14);
}

}  // namespace
}  // namespace sonde
