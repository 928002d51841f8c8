// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/restricted/nearest_free.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "tests/support/exact_reference.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

Pose upright_at(const Vec3& p) { return {Quat::Identity(), p}; }

bool named_pair_meets(const Body& a, const Body& b, const FirstFree& found,
                      const OneDofMotion& motion, double s) {
  return test::meet_by_edges(place(Transform(motion.at(s)), corners(surface(a), found.triangle_a)),
                             corners(surface(b), found.triangle_b));
}

// Reference: where the faces of two boxes pass each other, and how far the least height of a turned
// box is above a plane.
TEST(NearestFree, is_where_the_last_faces_pass_each_other) {
  const auto probe = test::body(test::box({0.2, 0.3, 0.1}));
  const auto fixed = test::body(test::box({0.5, 0.4, 0.7}));
  const Pose X = upright_at({0.13, -0.04, 0.21});
  const OneDofMotion motion = OneDofMotion::along(X, Vec3::UnitX());
  const auto found = nearest_free(*probe, *fixed, motion, 2);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->s, 0.35 - 0.13, 1e-12);
  EXPECT_EQ(found->X_FM.p, motion.at(found->s).p);
  EXPECT_TRUE(test::is_free(*probe, *fixed, Transform(found->X_FM)));
  EXPECT_TRUE(named_pair_meets(*probe, *fixed, *found, motion, found->s - 1e-9));
  EXPECT_FALSE(nearest_free(*probe, *fixed, motion, 0.2));
  EXPECT_NEAR(nearest_free(*probe, *fixed, motion.back(), 2)->s, 0.35 + 0.13, 1e-12);
}

// Reference: by hand. A rod hinged at its end, 0.1 under the plane at its far corner.
TEST(NearestFree, a_rod_turns_until_its_corner_is_in_the_plane) {
  const auto rod = test::body(test::scaled_and_moved(test::box({1, 0.1, 0.1}), 1, {0.5, 0, 0.05}));
  const auto ground = test::body(test::scaled_and_moved(test::box({9, 9, 1}), 1, {0, 0, -0.5}));
  const double hinge = 0.3, tilt = 0.6;
  const Quat down(Eigen::AngleAxisd(tilt, Vec3::UnitY()));
  const OneDofMotion motion =
      OneDofMotion::about({down, {0, 0, hinge}}, {0, 0, hinge}, -Vec3::UnitY());
  const auto found = nearest_free(*rod, *ground, motion, 2);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->s, tilt - std::asin(hinge), 1e-12);
}

TEST(NearestFree, a_pose_within_a_solid_is_not_free_though_no_triangles_meet) {
  const auto grain = test::body(test::box({0.01, 0.01, 0.01}));
  const auto block = test::body(test::box({1, 1, 1}));
  const OneDofMotion motion = OneDofMotion::along(upright_at({0.1, 0.2, 0.3}), Vec3::UnitZ());
  const auto found = nearest_free(*grain, *block, motion, 1);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->s, 0.5 + 0.005 - 0.3, 1e-12);
}

TEST(NearestFree, a_free_start_is_the_answer) {
  const auto cube = test::body(test::box({1, 1, 1}));
  const auto found =
      nearest_free(*cube, *cube, OneDofMotion::along(upright_at({0, 0, 2}), -Vec3::UnitZ()), 1);
  ASSERT_TRUE(found);
  EXPECT_LT(found->s, 1e-12);
}

// Reference: exact predicates on all pairs and winding numbers (brute force) at samples before.
TEST(NearestFree, no_pose_before_it_is_free) {
  std::mt19937_64 random(1);
  int found_some = 0;
  for (const auto& pair : test::body_pairs(31))
    for (int i = 0; i < 6; ++i) {
      const Pose X = test::random_pose(random, *pair.a, *pair.b, 0.4);
      if (test::is_free(*pair.a, *pair.b, Transform(X))) continue;
      const double size = pair.a->mass.radius + pair.b->mass.radius;
      const Vec3 d = test::random_rotation(random) * Vec3::UnitZ();
      const bool turning = i % 2 == 0;
      const OneDofMotion motion =
          turning ? OneDofMotion::about(X, X * pair.a->mass.com + size * d.unitOrthogonal(), d)
                  : OneDofMotion::along(X, d);
      const double most = turning ? 2 * std::numbers::pi : 2 * size;
      const auto found = nearest_free(*pair.a, *pair.b, motion, most);
      const double until = found ? found->s : most;
      for (int k = 0; k < 40; ++k) {
        const double s = until * (k + test::uniform(random, 0, 0.999)) / 40;
        EXPECT_FALSE(test::is_free(*pair.a, *pair.b, Transform(motion.at(s))))
            << pair.name << " " << s << " of " << until;
      }
      if (!found) continue;
      ++found_some;
      EXPECT_TRUE(test::is_free(*pair.a, *pair.b, Transform(found->X_FM))) << pair.name;
      // The pose is a few rounding errors beyond: 3e-8 m where the coordinates are 1e6 m.
      const double little = std::max(1e-7 * until, 1e-12 * X.p.cwiseAbs().maxCoeff());
      EXPECT_TRUE(named_pair_meets(*pair.a, *pair.b, *found, motion, found->s - little))
          << pair.name;
    }
  EXPECT_GT(found_some, 15);
}

TEST(NearestFree, tells_how_far_it_is_and_ends_when_it_is_told_to) {
  const auto cube = test::body(test::box({1, 1, 1}));
  const OneDofMotion motion = OneDofMotion::along(Pose(), Vec3::UnitX());
  std::vector<double> told;
  const auto note = [&](double share) {
    told.push_back(share);
    return true;
  };
  ASSERT_TRUE(nearest_free(*cube, *cube, motion, 4, note));
  ASSERT_GT(told.size(), 2u);
  EXPECT_EQ(told.front(), 0);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_LE(told.back(), 1.0 / 4);
  EXPECT_THROW(nearest_free(*cube, *cube, motion, 4, [](double) { return false; }), Cancelled);
}

}  // namespace
}  // namespace sonde
