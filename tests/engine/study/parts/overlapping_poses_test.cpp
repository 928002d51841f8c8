// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/parts/overlapping_poses.hpp"

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::never;

/// Two cubes of 2 m with the same axes overlap where their centres are up to 2 m apart.
std::vector<Pose> row_of_poses(int n, double step) {
  std::vector<Pose> out;
  for (int i = 0; i < n; ++i) out.push_back({Quat::Identity(), Vec3(step * i, 0, 0)});
  return out;
}

std::vector<double> places(const std::vector<Pose>& poses) {
  std::vector<double> out;
  for (const Pose& pose : poses) out.push_back(pose.p.x());
  return out;
}

TEST(OverlappingPoses, are_those_that_overlap_evenly_chosen) {
  const auto cube = test::body(test::box({2, 2, 2}));
  const std::vector<Pose> poses = row_of_poses(20, 0.25);  // the first nine overlap or touch
  EXPECT_EQ(overlapping_poses(*cube, *cube, poses, 0, never).size(), 9u);
  EXPECT_EQ(overlapping_poses(*cube, *cube, poses, 100, never).size(), 9u);
  EXPECT_EQ(places(overlapping_poses(*cube, *cube, poses, 3, never)),
            (std::vector<double>{0.25, 1, 1.75}));
  EXPECT_EQ(places(overlapping_poses(*cube, *cube, poses, 1, never)), std::vector<double>{1});
  EXPECT_TRUE(overlapping_poses(*cube, *cube, std::vector<Pose>{{Quat::Identity(), Vec3(9, 0, 0)}},
                                3, never)
                  .empty());
  EXPECT_THROW(overlapping_poses(*cube, *cube, poses, 3, [] { return true; }), Cancelled);
}

TEST(OverlappingPoses, random_ones_overlap_and_are_the_same_for_the_same_seed) {
  std::mt19937_64 random(3);
  const auto ring = test::body(test::torus(0.04, 0.015, 24, 12));
  for (const auto& fixed : {test::body(test::torus(0.06, 0.02, 24, 12)),
                            test::body(test::random_soup(random, 200, 0.1))}) {
    const auto poses = random_overlapping_poses(*ring, *fixed, 20, 7, never);
    ASSERT_EQ(poses.size(), 20u);
    for (const Pose& pose : poses) EXPECT_FALSE(test::is_free(*ring, *fixed, Transform(pose)));
    const auto again = random_overlapping_poses(*ring, *fixed, 20, 7, never);
    const auto other = random_overlapping_poses(*ring, *fixed, 20, 8, never);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_EQ(poses[i].p, again[i].p);
      EXPECT_EQ(poses[i].q.coeffs(), again[i].q.coeffs());
      EXPECT_NE(poses[i].p, other[i].p);
    }
  }
}

// The middle of the probe's surface at the middle of the fixed body's, on average: of a long box
// whose two ends are triangulated differently, so that drawing triangles alike would show.
TEST(OverlappingPoses, points_are_uniform_by_area) {
  PolygonSoup plate;  // 2 m along x, one half of it in 40 times as many triangles
  plate.points = {{-1, -0.5, 0}, {0, -0.5, 0}, {0, 0.5, 0}, {-1, 0.5, 0}};
  plate.polygons = {{0, 1, 2, 3}};
  for (std::size_t i = 0; i < 40; ++i) {
    const double x = static_cast<double>(i) / 40, width = 1.0 / 40;
    for (const Vec3& corner :
         {Vec3(x, -0.5, 0), Vec3(x + width, -0.5, 0), Vec3(x + width, 0.5, 0), Vec3(x, 0.5, 0)})
      plate.points.push_back(corner);
    plate.polygons.push_back({4 + 4 * i, 5 + 4 * i, 6 + 4 * i, 7 + 4 * i});
  }
  const auto fixed = test::body(plate);
  const auto probe = test::body(test::box({1e-3, 1e-3, 1e-3}));
  double sum = 0, squares = 0;
  const auto poses = random_overlapping_poses(*probe, *fixed, 2000, 1, never);
  for (const Pose& pose : poses) {
    sum += pose.p.x();
    squares += pose.p.x() * pose.p.x();
  }
  const auto n = static_cast<double>(poses.size());
  // Uniform in -1 to 1: mean 0 and mean square 1/3, with standard errors of 0.013 and 0.0067.
  EXPECT_NEAR(sum / n, 0, 0.05);
  EXPECT_NEAR(squares / n, 1.0 / 3, 0.03);
}

}  // namespace
}  // namespace sonde
