// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/point_grid.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Reference: every point against every box.
TEST(PointGrid, finds_all_points_in_a_box) {
  std::mt19937_64 random(5);
  std::vector<Vec3> points;
  std::vector<std::uint32_t> some;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    points.push_back(test::random_in_ball(random, 1));
    if (i % 3 != 0) some.push_back(i);
  }
  const PointGrid grid(points, some, Vec3::Constant(-1), 0.07);
  for (int k = 0; k < 200; ++k) {
    const Vec3 at = test::random_in_ball(random, 1), half = Vec3(0.02, 0.1, 0.3);
    const Eigen::AlignedBox3d box(Vec3(at - half), Vec3(at + half));
    std::set<std::uint32_t> found;
    grid.each_within(box.min(), box.max(), [&](std::uint32_t i) { found.insert(i); });
    for (const std::uint32_t i : some) {
      EXPECT_TRUE(!box.contains(points[i]) || found.contains(i));
    }
    for (const std::uint32_t i : found) EXPECT_NE(i % 3, 0u);
  }
}

}  // namespace
}  // namespace sonde
