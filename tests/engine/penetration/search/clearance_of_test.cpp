// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/clearance_of.hpp"

#include <gtest/gtest.h>

#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

// Reference: by hand.
TEST(ClearanceOf, two_boxes_is_the_gap_between_their_faces) {
  const auto a = test::body(test::box({1, 1, 1})), b = test::body(test::box({2, 2, 2}));
  const Clearance found = clearance_of(*a, *b, {Quat::Identity(), {0.1, 0.2, 2}}, false);
  EXPECT_EQ(found.distance, 0.5);
  EXPECT_FALSE(found.overlapping);
  EXPECT_EQ(found.on_probe.z(), 1.5);
  EXPECT_EQ(found.on_fixed.z(), 1);
  EXPECT_EQ((found.on_probe - found.on_fixed).norm(), 0.5);
  // The caller knows that a body within another overlaps it, though no triangles meet.
  const auto grain = test::body(test::box({0.5, 0.5, 0.5}));
  const Clearance within = clearance_of(*grain, *b, {Quat::Identity(), {0, 0, 0.25}}, true);
  EXPECT_EQ(within.distance, 0);
  EXPECT_TRUE(within.overlapping);
  EXPECT_EQ((within.on_probe - within.on_fixed).norm(), 0.5);
}

// Reference: all pairs of triangles. Rounding of the poses as in the tests of distance().
TEST(ClearanceOf, bodies_is_the_least_of_all_pairs_with_its_two_points) {
  std::mt19937_64 random(1);
  for (const auto& pair : test::body_pairs(9))
    for (int i = 0; i < 4; ++i) {
      const Pose X = test::random_pose(random, *pair.a, *pair.b, 2);
      if (!test::is_free(*pair.a, *pair.b, Transform(X))) continue;
      const Clearance found = clearance_of(*pair.a, *pair.b, X, false);
      const double wanted = test::least_distance_of_pairs(*pair.a, *pair.b, Transform(X));
      const double rounding = 1e-14 * (X.p.norm() + pair.a->mass.com.norm() +
                                       pair.b->mass.com.norm() + pair.a->mass.radius);
      EXPECT_NEAR(found.distance, wanted, 1e-9 * wanted + rounding) << pair.name;
      EXPECT_NEAR((found.on_probe - found.on_fixed).norm(), found.distance,
                  1e-9 * wanted + rounding)
          << pair.name;
    }
}

// Reference: by hand. So far away the square of the distance is no number; bodies are points.
TEST(ClearanceOf, bodies_at_any_distance_is_finite) {
  const auto cube = test::body(test::box({1, 1, 1}));
  for (const double far : {1e100, 1e149, 1e151, 1e200, 1e300}) {
    const Clearance found =
        clearance_of(*cube, *cube, {Quat::Identity(), {3 * far, 4 * far, 0}}, false);
    EXPECT_NEAR(found.distance / far, 5, 1e-12) << far;
    EXPECT_FALSE(found.overlapping);
    EXPECT_NEAR(found.on_probe.x() / far, 3, 1e-12);
    EXPECT_LE(found.on_fixed.cwiseAbs().maxCoeff(), 0.5);
  }
}

}  // namespace
}  // namespace sonde
