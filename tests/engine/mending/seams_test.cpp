// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/seams.hpp"

#include <gtest/gtest.h>

#include "engine/geometry/topology.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::size_t open_edges(const std::vector<EdgeUse>& uses) {
  std::size_t open = 0;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) { open += edge.size() % 2; });
  return open;
}

Seams seams_of(const Soup& soup) { return find_seams(soup, edge_uses(soup)); }

// Reference: the mesh before its corners were moved apart is closed.
TEST(Seams, corners_apart_by_rounding_are_joined) {
  std::uint64_t seed = 0;
  for (const PolygonSoup& mesh :
       {test::box({1, 2, 3}), test::icosphere(0.02, 2), test::torus(5, 1, 24, 12),
        test::torus_knot(2, 3, 2, 0.7, 0.3, 60, 8)})
    for (const double by : {1e-15, 1e-9, 1e-7, 2e-6}) {
      Eigen::AlignedBox3d box;
      for (const Vec3& x : mesh.points) box.extend(x);
      const double size = box.sizes().norm();
      const Soup soup = test::welded(test::cracked(mesh, by * size, ++seed));
      ASSERT_GT(open_edges(edge_uses(soup)), 0u);
      const Seams seams = seams_of(soup);
      EXPECT_EQ(open_edges(seams.uses), 0u) << by;
      // Only rounding is left of some corners where the move is that small.
      EXPECT_GT(seams.joined, 0u);
      EXPECT_LE(seams.reach, 1.001e-5 * size);
    }
}

// Errors of the size of the last reach leave some corners within it and others not. Reference: the
// mesh before its corners were moved apart is closed, but for the hole.
TEST(Seams, errors_of_the_size_of_the_reach_leave_nothing_half_joined) {
  std::uint64_t seed = 90;
  for (const PolygonSoup& mesh :
       {test::box({1, 2, 3}), test::icosphere(0.02, 2), test::torus(5, 1, 24, 12),
        test::lathed({{0, 0}, {2, 0}, {1, 3}, {0, 3}}, 16)})
    for (const double by : {4e-6, 6e-6, 8.7e-6})
      for (const bool holed : {false, true}) {
        Eigen::AlignedBox3d box;
        for (const Vec3& x : mesh.points) box.extend(x);
        const double size = box.sizes().norm();
        PolygonSoup triangles = test::triangulated(mesh);
        if (holed) triangles.polygons.erase(triangles.polygons.begin() + 1);
        const Soup soup = test::welded(test::cracked(triangles, by * size, ++seed));
        const Seams seams = seams_of(soup);
        EXPECT_EQ(open_edges(seams.uses), holed ? 3u : 0u) << by;
        EXPECT_LE(seams.reach, 1.001e-4 * size);
      }
}

// Corners within a fiftieth of their edges of each other may be a feature: a wider reach than the
// rounding of files leaves them.
TEST(Seams, a_wider_reach_is_well_below_the_edges) {
  const double side = 2e-3, slit = 8e-5;
  const PolygonSoup box = test::box({side, side, side}),
                    low = test::without(box, [&](const Vec3&x) { return x.z() > 0.4 * side; }),
                    high = test::without(box, [&](const Vec3&x) { return x.z() < -0.4 * side; });
  const PolygonSoup halves = test::joined(low, high, {0, 0, side + slit});
  for (const PolygonSoup& cracked :
       {test::icosphere(1, 1), test::box({1, 2, 1}), test::torus(1, 0.4, 12, 8)}) {
    const Soup soup =
        test::welded(test::joined(test::cracked(cracked, 3e-5, 4), halves, {3, 0, 0}));
    EXPECT_EQ(open_edges(seams_of(soup).uses), 8u) << "the openings of the two halves";
  }
}

// Far from the origin the rounding of a file in single precision is more than the reach.
TEST(Seams, rounding_to_single_precision_is_joined_wherever_it_is) {
  for (const double away : {10.0, 300.0, 1000.0, 5000.0})
    for (const PolygonSoup& mesh :
         {test::box({1, 2, 3}), test::icosphere(0.8, 2), test::torus(1, 0.3, 24, 12)}) {
      const PolygonSoup cut =
          test::moved(test::cut_beyond(mesh, Vec3(1, 0.3, 0.2), 0), [&](const Vec3& x) {
            return Vec3((x + Vec3(away, -away, away)).cast<float>().cast<double>());
          });
      const Soup soup = test::welded(cut);
      ASSERT_GT(open_edges(edge_uses(soup)), 0u);
      EXPECT_EQ(open_edges(seams_of(soup).uses), 0u) << away;
    }
}

// A cut along a plane: on one side every triangle is cut in four.
TEST(Seams, corners_on_the_sides_of_others_cut_them) {
  for (const PolygonSoup& mesh :
       {test::box({1, 2, 3}), test::icosphere(0.02, 2), test::torus(5, 1, 24, 12)})
    for (const double by : {0.0, 1e-9, 1e-7}) {
      const Soup soup =
          test::welded(test::cut_beyond(mesh, Vec3(1, 0.3, 0.2), 0, by * mesh.points[0].norm()));
      ASSERT_GT(open_edges(edge_uses(soup)), 0u);
      const Seams seams = seams_of(soup);
      EXPECT_EQ(open_edges(seams.uses), 0u) << by;
      EXPECT_EQ(seams.on_edges, seams.cuts.size());
      EXPECT_EQ(seams.unsearched, 0u);
    }
}

TEST(Seams, what_is_drawn_apart_stays_apart) {
  // A slit of a thousandth of the size, and two plates that face each other at that distance.
  const PolygonSoup plate =
      test::without(test::box({1, 1, 1}), [](const Vec3& x) { return x.z() < 0.49; });
  for (const double gap : {1e-2, 1e-3, 1e-4}) {
    const Soup soup = test::welded(test::joined(plate, plate, {0, 0, gap}));
    const Seams seams = seams_of(soup);
    EXPECT_EQ(seams.joined, 0u) << gap;
    EXPECT_EQ(open_edges(seams.uses), 8u);
  }
}

// Fine detail: a corner's own edges are shorter than the reach of a coarse step would be.
TEST(Seams, edges_that_small_are_not_closed_up) {
  const double tiny = 2e-6;
  const Soup soup = test::welded(test::joined(
      test::box({1, 1, 1}),
      test::without(test::box({tiny, tiny, tiny}), [](const Vec3& x) { return x.z() > 0.9e-6; }),
      {3, 0, 0}));
  const Seams seams = seams_of(soup);
  EXPECT_EQ(seams.joined, 0u);
  EXPECT_EQ(open_edges(seams.uses), 4u);
}

TEST(Seams, a_closed_mesh_has_none) {
  const Soup soup = test::welded(test::torus(1, 0.3, 20, 10));
  const Seams seams = seams_of(soup);
  EXPECT_EQ(seams.joined + seams.on_edges + seams.cuts.size(), 0u);
  EXPECT_EQ(seams.uses.size(), 3 * soup.triangles.size());
}

}  // namespace
}  // namespace sonde
