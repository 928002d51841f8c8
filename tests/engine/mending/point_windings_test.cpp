// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/point_windings.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// The sum of the solid angles of triangles, over 4π (Van Oosterom and Strackee, 1983).
double solid_angles(const Soup& soup, const Vec3& x) {
  double sum = 0;
  for (const Triangle& t : soup.triangles) {
    const Vec3 a = soup.vertices[t[0]] - x, b = soup.vertices[t[1]] - x,
               c = soup.vertices[t[2]] - x;
    sum += std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                             b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum / (2 * std::numbers::pi);
}

// Reference: solid angles, which are exact to rounding for closed meshes.
TEST(PointWindings, are_those_of_solid_angles) {
  std::mt19937_64 random(11);
  const PolygonSoup parts[] = {test::icosphere(1, 2),
                               test::turned_over(test::torus(1.2, 0.4, 20, 12)),
                               test::box({1.5, 0.5, 0.7})};
  Sealed sealed;
  std::vector<Soup> alone;
  PolygonSoup all;
  for (std::uint32_t p = 0; p < 3; ++p) {
    alone.push_back(test::soup_of(parts[p]));
    all = test::joined(all, parts[p]);
    sealed.part.insert(sealed.part.end(), alone[p].triangles.size(), p);
  }
  sealed.soup = test::soup_of(all);
  sealed.cap.assign(sealed.part.size(), Sealed::no_cap);
  std::vector<PartPoint> points;
  for (int k = 0; k < 500; ++k) points.push_back({test::random_in_ball(random, 1.8), 0});
  const std::vector<PartWindings> found = part_windings(sealed, points);
  int inside = 0;
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::uint32_t p = 0; p < 3; ++p) {
      int winding = 0;
      for (const auto& [part, times] : found[k]) winding += part == p ? times : 0;
      EXPECT_NEAR(solid_angles(alone[p], points[k].x), winding, 1e-6);
      inside += winding != 0;
    }
  EXPECT_GT(inside, 100);
}

TEST(PointWindings, a_part_does_not_wind_around_a_point_that_lies_on_it) {
  Sealed sealed;
  sealed.soup = test::soup_of(test::box({2, 2, 2}));
  sealed.part.assign(12, 0);
  const std::vector<PartPoint> points{{{0.2, 0.3, 1}, 1}, {{0.2, 0.3, 0.9}, 1}};
  const auto found = part_windings(sealed, points);
  EXPECT_TRUE(found[0].empty());
  EXPECT_EQ(found[1], (PartWindings{{0, 1}}));
}

// Reference: the centre of a face of a convex part, from which the part lies on one side.
TEST(PointWindings, points_within_lie_just_below_the_faces_of_their_part) {
  for (const PolygonSoup& mesh :
       {test::box({2, 1, 3}), test::icosphere(0.5, 2), test::tetrahedron(1)})
    for (const bool over : {false, true}) {
      Sealed sealed;
      sealed.soup = test::soup_of(over ? test::turned_over(mesh) : mesh);
      sealed.part.assign(sealed.soup.triangles.size(), 0);
      std::vector<PartPoint> points;
      for (const Triangle& t : sealed.soup.triangles)
        points.push_back({(sealed.soup.vertices[t[0]] + sealed.soup.vertices[t[1]] +
                           sealed.soup.vertices[t[2]]) /
                              3,
                          0});
      const double near = 1e-4;
      const std::vector<PartPoint> within = points_within(sealed, points, near);
      ASSERT_EQ(within.size(), points.size());
      for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_NEAR(std::abs(solid_angles(sealed.soup, within[k].x)), 1, 1e-6);
        EXPECT_LT((within[k].x - points[k].x).norm(), near * 4);
      }
    }
}

}  // namespace
}  // namespace sonde
