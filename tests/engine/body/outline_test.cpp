// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/body/body.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Soup soup(const PolygonSoup& polygons) { return triangulate(polygons).soup; }

TEST(Outline, has_about_as_many_triangles_as_asked_for) {
  std::mt19937_64 random(1);
  for (const Soup& all : {soup(test::sphere(0.3, 100, 200)), soup(test::torus(1, 0.2, 300, 60)),
                          soup(test::torus_knot(2, 3, 0.06, 0.025, 0.015, 800, 30)),
                          soup(test::random_soup(random, 20'000, 2))}) {
    for (const std::size_t asked : {300u, 1000u}) {
      const Soup few = outline(all, asked);
      EXPECT_GE(few.triangles.size(), asked / 4);
      EXPECT_LE(few.triangles.size(), 2 * asked);
    }
  }
}

// Reference: the corners of the soup itself.
TEST(Outline, is_made_of_the_soups_own_corners_without_repeats) {
  const Soup all = soup(test::torus(1, 0.2, 200, 50));
  const Soup few = outline(all, 500);
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  const std::set<Vec3, decltype(less)> corners(all.vertices.begin(), all.vertices.end(), less);
  for (const Vec3& x : few.vertices) EXPECT_TRUE(corners.contains(x));
  std::set<Triangle> seen;
  for (Triangle t : few.triangles) {
    EXPECT_FALSE(is_degenerate(few.vertices[t[0]], few.vertices[t[1]], few.vertices[t[2]]));
    std::ranges::sort(t);
    EXPECT_TRUE(seen.insert(t).second);
  }
}

// Reference: the sphere. A triangle of edges of 0.2 r leaves it by 0.005 r in its middle.
TEST(Outline, of_a_sphere_lies_near_it_all_around) {
  const Soup few = outline(soup(test::sphere(1, 200, 400)), 1000);
  double area = 0;
  for (const Triangle& t : few.triangles) {
    const Vec3 &a = few.vertices[t[0]], &b = few.vertices[t[1]], &c = few.vertices[t[2]];
    EXPECT_GT(((a + b + c) / 3).norm(), 0.98);
    area += (b - a).cross(c - a).norm() / 2;
  }
  EXPECT_NEAR(area / (4 * 3.14159265), 1, 0.05);
}

TEST(Outline, belongs_to_bodies_that_are_finer) {
  EXPECT_EQ(test::body(test::sphere(1, 20, 30))->outline, nullptr);
  const auto body = test::body(test::sphere(1, 100, 100));
  ASSERT_NE(body->outline, nullptr);
  EXPECT_EQ(&roughly(*body), body->outline.get());
  EXPECT_EQ(body->outline->mass.radius, body->mass.radius);
  EXPECT_EQ(body->outline->mass.inertia, body->mass.inertia);
  EXPECT_FALSE(body->outline->tree.empty());
  EXPECT_GT(bytes(*body), bytes(*body->outline) + bytes(body->tree));
}

TEST(Outline, can_be_cancelled) {
  EXPECT_THROW(outline(soup(test::sphere(1, 100, 100)), 1000, [](double) { return false; }),
               Cancelled);
}

}  // namespace
}  // namespace sonde
