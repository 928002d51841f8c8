// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/caps.hpp"

#include <gtest/gtest.h>

#include "engine/geometry/topology.hpp"
#include "engine/mending/sealed.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

struct Capped {
  explicit Capped(const PolygonSoup& mesh)
      : soup(test::welded(mesh)),
        seams(find_seams(soup, edge_uses(soup))),
        orientation(find_orientation(soup, seams.uses)),
        caps(find_caps(soup, seams.uses, orientation)),
        sealed(seal(soup, seams, orientation, caps)) {}
  double area() const {
    double sum = 0;
    for (const Cap& cap : caps) sum += cap.area;
    return sum;
  }
  Soup soup;
  Seams seams;
  Orientation orientation;
  std::vector<Cap> caps;
  Sealed sealed;
};

// Reference: the area of the opening, by its formula.
TEST(Caps, an_opening_in_a_plane_is_covered_once) {
  // A prism over an L without its top: a concave opening.
  const std::vector<Eigen::Vector2d> l{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  const Capped open(test::without(test::prism(l, 2), [](const Vec3& x) { return x.z() > 1.99; }));
  ASSERT_EQ(open.caps.size(), 1u);
  EXPECT_EQ(open.caps[0].loop.size(), 6u);
  EXPECT_NEAR(open.area(), 4, 1e-12);
  EXPECT_TRUE(analyse_topology(open.sealed.soup).closed);
}

// Whatever is missing, what is left and its caps are closed.
TEST(Caps, close_every_part) {
  const auto holes = [](const Vec3& x) { return std::sin(9 * x.x()) * std::sin(11 * x.y()) > 0.6; };
  for (const PolygonSoup& mesh :
       {test::without(test::icosphere(1, 3), holes),
        test::without(test::torus(2, 0.6, 40, 20), holes),
        test::without(test::torus_knot(2, 3, 2, 0.7, 0.3, 90, 12), holes),
        test::joined(test::tetrahedron(1), test::without(test::box({1, 1, 1}), holes),
                     {3, 0, 0})}) {
    const Capped capped(mesh);
    EXPECT_GT(capped.caps.size(), 0u);
    EXPECT_EQ(analyse_topology(capped.sealed.soup).misoriented_edges, 0u);
    EXPECT_EQ(analyse_topology(capped.sealed.soup).open_edges, 0u);
  }
}

TEST(Caps, a_closed_mesh_has_none) {
  EXPECT_TRUE(Capped(test::torus(1, 0.3, 20, 10)).caps.empty());
}

}  // namespace
}  // namespace sonde
