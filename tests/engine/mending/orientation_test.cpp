// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/orientation.hpp"

#include <gtest/gtest.h>

#include <random>

#include "engine/geometry/topology.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Orientation orientation_of(const Soup& soup) { return find_orientation(soup, edge_uses(soup)); }

// Reference: the mesh before some of its triangles were turned.
TEST(Orientation, triangles_turned_at_random_are_turned_back) {
  std::mt19937 random(7);
  for (const PolygonSoup& mesh :
       {test::box({1, 2, 3}), test::icosphere(1, 3), test::torus(1, 0.3, 24, 12)})
    for (const unsigned one_of : {1000u, 10u, 3u}) {
      Soup soup = test::welded(mesh);
      std::vector<bool> was(soup.triangles.size());
      for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        was[i] = random() % one_of == 0;
        if (was[i]) std::swap(soup.triangles[i][1], soup.triangles[i][2]);
      }
      const Orientation found = orientation_of(soup);
      EXPECT_EQ(found.parts, 1u);
      EXPECT_EQ(found.conflicts[0], 0u);
      // By area, the majority keeps its way.
      double agree = 0, all = 0;
      for (std::size_t i = 0; i < was.size(); ++i) {
        const Triangle& t = soup.triangles[i];
        const Vec3& a = soup.vertices[t[0]];
        const double area = (soup.vertices[t[1]] - a).cross(soup.vertices[t[2]] - a).norm();
        all += area;
        agree += was[i] ? 0 : area;
      }
      const bool kept = agree > all / 2;
      for (std::size_t i = 0; i < was.size(); ++i) EXPECT_EQ(found.turned[i], was[i] == kept);
    }
}

// Reference: a Möbius strip, and the Klein bottle of two of them, have one side.
TEST(Orientation, what_has_one_side_is_told) {
  for (const int n : {12, 31}) {
    Soup strip;
    for (int i = 0; i < n; ++i) {
      const double a = test::two_pi * i / n;
      const Vec3 out(std::cos(a), std::sin(a), 0);
      const Vec3 across = std::cos(a / 2) * out + std::sin(a / 2) * Vec3::UnitZ();
      strip.vertices.push_back(2 * out + 0.5 * across);
      strip.vertices.push_back(2 * out - 0.5 * across);
    }
    for (int i = 0; i < n; ++i) {
      const auto a = static_cast<std::uint32_t>(2 * i), b = a + 1;
      const bool last = i == n - 1;
      const std::uint32_t c = last ? 1 : a + 2, d = last ? 0 : a + 3;
      strip.triangles.push_back({a, b, d});
      strip.triangles.push_back({a, d, c});
    }
    EXPECT_GE(orientation_of(strip).conflicts[0], 1u);
  }
}

// Two solids that touch along an edge, a corner or a face are written one after the other.
TEST(Orientation, bodies_that_share_an_edge_or_a_face_are_parts_of_their_own) {
  const PolygonSoup box = test::box({1, 1, 1});
  for (const Vec3& by : {Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(1, 0, 0)})
    for (const bool over : {false, true}) {
      const Soup soup = test::welded(test::joined(box, over ? test::turned_over(box) : box, by));
      const Orientation found = orientation_of(soup);
      EXPECT_EQ(found.parts, 2u) << by.transpose();
      EXPECT_EQ(found.turned_triangles, 0u);
      EXPECT_EQ(found.conflicts, (std::vector<std::size_t>{0, 0}));
    }
}

// A box with a wall in it: at the wall's outline three sheets meet, and all hang together.
TEST(Orientation, a_wall_inside_belongs_to_what_holds_it) {
  PolygonSoup mesh = test::triangulated(test::box({1, 1, 1}));
  mesh.polygons.push_back({0, 1, 7});  // from edge to edge through the middle
  mesh.polygons.push_back({0, 7, 6});
  EXPECT_EQ(orientation_of(test::welded(mesh)).parts, 1u);
}

}  // namespace
}  // namespace sonde
