// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/move_faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "tests/engine/offset/prisms.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

MovedFaces moved_by_way(const PolygonSoup& polygons, double by, const Progress& progress = {}) {
  const Soup soup = triangulate_all(polygons);
  return move_faces(soup, find_fans(soup, 0), by, 0, progress);
}
double volume_of(const Soup& soup) { return mass_by_volume(soup).measure; }

// Reference: the volume of the prism on its outline, moved by hand.
TEST(MoveFaces, a_prism_becomes_that_on_its_moved_outline) {
  for (const test::Outline& outline :
       {test::rectangle(2, 1), test::regular(6, 1), test::dovetail(1, 0.5, 1.2)})
    for (const double by : {0.02, -0.03}) {
      const MovedFaces found = moved_by_way(test::prism(outline, 2), by);
      const double wanted = test::area(test::moved(outline, by)) * (2 + 2 * by);
      EXPECT_NEAR(volume_of(found.soup), wanted, 1e-12);
      EXPECT_EQ(found.offset.by, by);
      EXPECT_EQ(found.offset.held_back, 0u);
      EXPECT_EQ(found.offset.vanished, 0u);
      EXPECT_EQ(found.offset.least, std::abs(by));
      EXPECT_TRUE(found.turned_over.empty());
      EXPECT_TRUE(found.folded.empty());
      ASSERT_EQ(found.from.size(), found.soup.triangles.size());
      const std::set<std::uint32_t> all(found.from.begin(), found.from.end());
      EXPECT_EQ(all.size(), found.from.size());
    }
}

// Reference: by hand. The corner of a box goes by √3 times the length.
TEST(MoveFaces, the_furthest_corner_of_a_box_goes_along_its_diagonal) {
  const MovedFaces found = moved_by_way(test::box({1, 1, 1}), 0.01);
  EXPECT_NEAR(found.offset.furthest, 0.01 * std::sqrt(3.0), 1e-15);
  for (const Vec3& x : found.soup.vertices)
    EXPECT_LT((x.cwiseAbs() - Vec3::Constant(0.51)).norm(), 1e-15);
}

// Reference: by hand. A hole shrinks where the block grows.
TEST(MoveFaces, a_hole_gets_smaller_where_the_solid_gets_larger) {
  const test::Outline hole = test::rectangle(1, 2);
  for (const double by : {0.05, -0.05}) {
    const MovedFaces found = moved_by_way(test::block_with_hole(hole, 1), by);
    const double across =
        test::area(test::moved(test::rectangle(2.5, 5), by)) - test::area(test::moved(hole, -by));
    EXPECT_NEAR(volume_of(found.soup), across * (1 + 2 * by), 1e-12);
  }
}

// Reference: the outline without its arcs. Corners rounded by less than the way lose their arcs.
TEST(MoveFaces, an_arc_smaller_than_the_way_vanishes) {
  const test::Outline outline = test::rounded(2, 1, 0.01, 4);
  const MovedFaces found = moved_by_way(test::prism(outline, 1), -0.1);
  EXPECT_GT(found.offset.vanished, 0u);
  EXPECT_TRUE(found.turned_over.empty());
  EXPECT_NEAR(volume_of(found.soup), (2 - 0.2) * (1 - 0.2) * (1 - 0.2), 1e-3);
  EXPECT_LE(volume_of(found.soup), (2 - 0.2) * (1 - 0.2) * (1 - 0.2) + 1e-12);
}

TEST(MoveFaces, a_plate_thinner_than_twice_the_way_is_turned_over) {
  const MovedFaces found = moved_by_way(test::box({1, 1, 0.1}), -0.06);
  EXPECT_FALSE(found.turned_over.empty() && !found.soup.triangles.empty());
  EXPECT_TRUE(moved_by_way(test::box({1, 1, 0.1}), -0.04).turned_over.empty());
  EXPECT_NEAR(volume_of(moved_by_way(test::box({1, 1, 0.1}), -0.04).soup),
              0.92 * 0.92 * (0.1 - 0.08), 1e-12);
}

// Reference: by hand. The tip of a blade of 0.1 rad would go twenty times the way.
TEST(MoveFaces, a_corner_that_is_held_back_is_told) {
  const test::Outline blade{{0, 0}, {1, -std::tan(0.05)}, {1, std::tan(0.05)}};
  const MovedFaces found = moved_by_way(test::prism(blade, 1), 1e-3);
  EXPECT_EQ(found.offset.held_back, 2u);
  EXPECT_LT(found.offset.least, 1e-3);
  EXPECT_GT(found.offset.least, 0);
  EXPECT_NEAR(found.offset.furthest, 1e-2, 1e-12);  // ten times the way
}

TEST(MoveFaces, tells_how_far_it_is_and_can_be_cancelled) {
  std::vector<double> told;
  moved_by_way(test::box({1, 1, 1}), 0.01,
               [&](double share) { return told.push_back(share), true; });
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_EQ(told.back(), 1);
  EXPECT_THROW(moved_by_way(test::box({1, 1, 1}), 0.01, [](double) { return false; }), Cancelled);
}

}  // namespace
}  // namespace sonde
