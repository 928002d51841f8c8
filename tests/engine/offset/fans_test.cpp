// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/fans.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/geometry/topology.hpp"
#include "tests/engine/offset/prisms.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Soup soup_of(const PolygonSoup& polygons) { return compacted(triangulate(polygons).soup); }

Fans fans_of(const PolygonSoup& polygons) { return find_fans(soup_of(polygons), 1e-9); }

std::size_t pieces(const Fans& fans) {
  const auto piece = pieces_of(fans);
  return 1 + *std::ranges::max_element(piece);
}

TEST(Fans, a_closed_surface_has_one_at_each_vertex) {
  for (const PolygonSoup& shape :
       {test::box({1, 2, 3}), test::sphere(1, 9, 12), test::torus(1, 0.3, 20, 10)}) {
    const Soup soup = soup_of(shape);
    const Fans fans = find_fans(soup, 1e-9);
    EXPECT_EQ(fans.count(), soup.vertices.size());
    EXPECT_EQ(pieces(fans), 1U);
    EXPECT_TRUE(fans.beside.empty());
  }
}

TEST(Fans, parts_that_touch_have_corners_of_their_own) {
  const PolygonSoup box = test::box({1, 1, 1});
  for (const Vec3& at : {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(0, -1, 1), Vec3(0, 0, 1)}) {
    const Fans fans = fans_of(test::together(box, box, at));
    EXPECT_EQ(fans.count(), 16U) << at.transpose();
    EXPECT_EQ(pieces(fans), 2U) << at.transpose();
  }
}

TEST(Fans, about_one_edge_material_holds_together) {
  // Wedges round the z axis that share it: angles from a to a + 0.5.
  PolygonSoup all;
  for (const double a : {0.2, 1.4, 3.0, 4.4}) {
    const test::Outline wedge{
        {0, 0}, {std::cos(a), std::sin(a)}, {std::cos(a + 0.5), std::sin(a + 0.5)}};
    all = test::together(all, test::prism(wedge, 1));
    const Fans fans = fans_of(all);
    EXPECT_EQ(pieces(fans), all.points.size() / 6);
    EXPECT_EQ(fans.count(), all.points.size());
  }
}

TEST(Fans, at_an_opening_a_vertex_on_an_edge_goes_with_its_face) {
  PolygonSoup box = test::box({1, 1, 1});
  box.points.emplace_back(0.2, -0.5, -0.5);
  box.polygons[2] = {0, 8, 5, 4};
  box.polygons.push_back({8, 1, 5});  // the face below is not cut
  const Soup soup = soup_of(box);
  const Fans fans = find_fans(soup, 1e-9);
  EXPECT_EQ(fans.count(), soup.vertices.size());
  EXPECT_EQ(pieces(fans), 1U);
  ASSERT_EQ(fans.beside.size(), 1U);
  const auto [fan, triangle] = fans.beside[0];
  EXPECT_EQ(soup.vertices[fans.vertex[fan]], Vec3(0.2, -0.5, -0.5));
  for (const std::uint32_t corner : soup.triangles[triangle])
    EXPECT_EQ(soup.vertices[corner].z(), -0.5) << "of the face below";
}

}  // namespace
}  // namespace sonde
