// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/round_face.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/geometry/topology.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A rod about z of so many sides and rings, radius 0.3, height 2, between flat ends.
Soup rod(std::uint32_t sides, std::uint32_t rings) {
  Soup soup;
  for (std::uint32_t k = 0; k <= rings; ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      soup.vertices.push_back({0.3 * std::cos(angle), 0.3 * std::sin(angle), 2.0 * k / rings - 1});
    }
  for (std::uint32_t k = 0; k < rings; ++k)
    for (std::uint32_t i = 0; i < sides; ++i) {
      const std::uint32_t a = k * sides + i, b = k * sides + (i + 1) % sides;
      soup.triangles.push_back({a, b, b + sides});
      soup.triangles.push_back({a, b + sides, a + sides});
    }
  for (std::uint32_t i = 1; i + 1 < sides; ++i) {
    soup.triangles.push_back({0, i + 1, i});
    soup.triangles.push_back({rings * sides, rings * sides + i, rings * sides + i + 1});
  }
  return soup;
}

// Reference: the rod as it was made.
TEST(RoundFace, of_a_rod_has_its_axis_and_its_ends_have_none) {
  std::mt19937_64 random(5);
  for (const std::uint32_t sides : {12u, 24u, 100u, 2000u})
    for (const std::uint32_t rings : {1u, 7u}) {
      Soup soup = rod(sides, rings);
      const Pose X{test::random_rotation(random), test::random_in_ball(random, 3)};
      for (Vec3& x : soup.vertices) x = X * x;
      const auto found = round_face(soup, sides + 3);
      ASSERT_TRUE(found) << sides << ' ' << rings;
      EXPECT_LT(found->along.cross(X.q * Vec3::UnitZ()).norm(), 1e-9);
      EXPECT_LT((found->at - X.p).cross(X.q * Vec3::UnitZ()).norm(), 1e-9);
      EXPECT_NEAR(found->radius, 0.3, 1e-9);
      EXPECT_FALSE(round_face(soup, 2 * sides * rings)) << "an end is flat";
    }
}

TEST(RoundFace, of_what_is_flat_or_otherwise_round_there_is_none) {
  const auto soup_of = [](const PolygonSoup& polygons) {
    return compacted(triangulate(polygons).soup);
  };
  EXPECT_FALSE(round_face(soup_of(test::box({1, 2, 3})), 0));
  EXPECT_FALSE(round_face(soup_of(test::torus(1, 0.4, 48, 24)), 17));
  EXPECT_FALSE(round_face(soup_of(test::sphere(1, 24, 48)), 300));
  EXPECT_FALSE(round_face(soup_of(test::sphere(1, 300, 600)), 150'000));
}

}  // namespace
}  // namespace sonde
