// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/ray_hit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// Where a ray from outside enters a box round the origin, by its three slabs; negative: it misses.
double enters(const Vec3& half, const Vec3& from, const Vec3& direction) {
  double in = 0, out = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double one = (-half[i] - from[i]) / direction[i],
                 other = (half[i] - from[i]) / direction[i];
    in = std::max(in, std::min(one, other));
    out = std::min(out, std::max(one, other));
  }
  return in <= out ? in : -1;
}

/// The reference is the slabs' own intersection, exact for a box.
TEST(RayHit, of_a_box_is_where_the_ray_enters_its_slabs) {
  std::mt19937_64 random(3);
  const Vec3 size(0.1, 0.2, 0.05);
  const auto box = test::body(test::box(size));
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 direction = test::random_in_ball(random, 1).normalized();
    const Vec3 from = test::random_in_ball(random, 0.12) - direction;
    const double expected = enters(size / 2, from, direction);
    const auto hit = ray_hit(box->soup, from, direction);
    ASSERT_EQ(hit.has_value(), expected >= 0) << i;
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(hit->distance, expected, 1e-12);
  }
  EXPECT_GT(hits, 300);
}

TEST(RayHit, passes_what_does_not_count) {
  const auto box = test::body(test::box(Vec3(0.1, 0.1, 0.1)));
  const auto hit = ray_hit(box->soup, Vec3(-1, 0.01, 0.02), Vec3::UnitX(),
                           [](const Vec3& x) { return x.x() > 0; });
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 1.05, 1e-12) << "the far face, from inside";
  EXPECT_FALSE(ray_hit(box->soup, Vec3(-1, 0.01, 0.02), -Vec3::UnitX())) << "it lies behind";
}

}  // namespace
}  // namespace sonde
