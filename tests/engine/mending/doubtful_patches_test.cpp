// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/doubtful_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "engine/geometry/mass_integrals.hpp"
#include "engine/mending/mend.hpp"
#include "engine/mending/point_windings.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Mended mend_whole(const PolygonSoup& mesh) {
  const Soup soup = compacted(triangulate_all(mesh));
  return mend(soup, analyse_topology(soup), Model::automatic, "a.off");
}

struct Shape {
  const char* name;
  PolygonSoup mesh;
  double volume;      // m³, in closed form
  Vec3 inside, hole;  // a point of the inside, and one outside that it is around
};

/// Each in several tessellations.
std::vector<Shape> shapes() {
  std::vector<Shape> out;
  const auto lathed = [&](const char* name, const std::vector<Eigen::Vector2d>& profile, int n,
                          const Vec3& inside, const Vec3& hole) {
    out.push_back({name, test::lathed(profile, n), test::lathed_volume(profile, n), inside, hole});
  };
  const PolygonSoup ell = test::prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
  out.push_back({"ell", ell, 4, {0.51, 0.52, 0.53}, {2.03, 1.51, 0.5}});
  out.push_back({"finer ell",
                 test::cut_beyond(test::cut_beyond(ell, {1, 0, 0}, -9), {1, 0, 0}, -9),
                 4,
                 {0.51, 0.52, 0.53},
                 {2.03, 1.51, 0.5}});
  for (const int n : {6, 40}) {
    lathed("ring", {{0.5, 0}, {1, 0}, {1, 0.4}, {0.5, 0.4}}, n, {0.71, 0.02, 0.21}, {0, 0.01, 0.2});
    lathed("cone", {{0, 0}, {1, 0}, {0, 2}}, n, {0.01, 0.02, 0.6}, {0.8, 0.7, 1.4});
    lathed("cup", {{0, 0}, {1, 0}, {1, 2}, {0.9, 2}, {0.9, 0.1}, {0, 0.1}}, n, {0.01, 0.02, 0.04},
           {0.01, 0.02, 1.03});
  }
  return out;
}

/// Some triangles again, so many that a twelfth of all are.
PolygonSoup some_repeated(PolygonSoup mesh, bool turned, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::size_t> which(mesh.polygons.size());
  std::iota(which.begin(), which.end(), 0u);
  std::shuffle(which.begin(), which.end(), random);
  which.resize(std::max<std::size_t>(1, which.size() / 12));
  return test::repeated(std::move(mesh), which, turned);
}

void expect_as_unrepeated(const Shape& shape, const PolygonSoup& mesh, std::size_t triangles,
                          double rounding) {
  const Mended m = mend_whole(mesh);
  EXPECT_EQ(m.repairs.solid_parts, 1u) << m.why;
  EXPECT_EQ(m.repairs.parts, 1u);
  EXPECT_EQ(m.repairs.caps, 0u);
  EXPECT_EQ(m.repairs.hidden, 0u);
  EXPECT_EQ(m.repairs.repeated, mesh.polygons.size() - triangles);
  EXPECT_EQ(m.triangles.size(), triangles);
  if (m.solid.soup.triangles.empty()) return;
  EXPECT_NEAR(mass_by_volume(m.solid.soup).measure, shape.volume, rounding * shape.volume);
  const std::vector<PartWindings> around =
      part_windings(m.solid, {{shape.inside, 0}, {shape.hole, 0}});
  EXPECT_EQ(around[0], (PartWindings{{0, 1}}));
  EXPECT_TRUE(around[1].empty());
}

// Reference: the volume in closed form, and the mesh without its repeats.
TEST(DoubtfulPatches, repeats_beside_corners_on_sides_stay_once) {
  for (const Shape& shape : shapes())
    for (const double by : {0.0, 1e-9, 1e-8, 1e-7})
      for (const bool turned : {false, true})
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
          SCOPED_TRACE(std::string(shape.name) + (turned ? ", turned" : "") +
                       ", off by: " + std::to_string(by * 1e9) + "e-9, " + std::to_string(seed));
          const PolygonSoup cut = test::cut_here_and_there(shape.mesh, 3, by, seed);
          expect_as_unrepeated(shape, some_repeated(cut, turned, seed), cut.polygons.size(),
                               1e-12 + 20 * by);
        }
}

TEST(DoubtfulPatches, repeats_beside_cracks_and_corners_on_sides_stay_once) {
  for (const Shape& shape : shapes())
    for (const double by : {1e-9, 1e-7})
      for (const bool turned : {false, true})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
          SCOPED_TRACE(std::string(shape.name) + (turned ? ", turned" : "") +
                       ", off by: " + std::to_string(by * 1e9) + "e-9, " + std::to_string(seed));
          const PolygonSoup cut =
              test::cut_here_and_there(test::cracked(shape.mesh, by, seed), 3, 0, seed);
          expect_as_unrepeated(shape, some_repeated(cut, turned, seed), cut.polygons.size(),
                               1e-12 + 50 * by);
        }
}

// Each triangle of the mesh in turn, with a corner on one of the sides of another in turn.
TEST(DoubtfulPatches, one_repeat_and_one_corner_on_a_side_anywhere) {
  const PolygonSoup box = test::triangulated(test::box({1, 1, 1}));
  const Shape shape{"box", box, 1, {0.01, 0.02, 0.03}, {0.8, 0.1, 0.2}};
  for (std::size_t cut = 0; cut < 12; ++cut)
    for (std::size_t side = 0; side < 3; ++side)
      for (std::size_t again = 0; again < 13; ++again)
        for (const bool turned : {false, true}) {
          PolygonSoup mesh = box;
          const Polygon t = box.polygons[cut];
          const std::size_t a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
          mesh.points.push_back(0.6 * mesh.points[a] + 0.4 * mesh.points[b]);
          mesh.polygons[cut] = {a, mesh.points.size() - 1, c};
          mesh.polygons.push_back({mesh.points.size() - 1, b, c});
          SCOPED_TRACE(testing::Message() << cut << ' ' << side << ' ' << again << ' ' << turned);
          expect_as_unrepeated(shape, test::repeated(mesh, {again}, turned), 13, 1e-12);
        }
}

// What is shared by two bodies, face to face, stays a wall: nothing of it bounds the inside.
TEST(DoubtfulPatches, a_wall_with_corners_on_its_rim_stays_a_wall) {
  const PolygonSoup box = test::box({1, 1, 1});
  for (const int finer : {0, 1, 2}) {
    PolygonSoup one = box;
    for (int k = 0; k < finer; ++k) one = test::cut_beyond(one, {1, 0, 0}, -9);
    const auto in_wall = [&](const PolygonSoup& mesh, const Polygon& t) {
      return std::ranges::all_of(t, [&](std::size_t i) { return mesh.points[i].x() == 0.5; });
    };
    const PolygonSoup both = test::triangulated(test::joined(one, one, {1, 0, 0}));
    for (const double by : {0.0, 1e-9, 1e-7})
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(testing::Message() << finer << ' ' << by << ' ' << seed);
        PolygonSoup rest{both.points, {}}, wall{both.points, {}};
        for (const Polygon& t : both.polygons)
          (in_wall(both, t) ? wall : rest).polygons.push_back(t);
        // The sides are cut at corners of their own on the rim of the wall, and elsewhere.
        PolygonSoup mesh = test::cut_here_and_there(rest, 2, by, seed);
        mesh.polygons.insert(mesh.polygons.end(), wall.polygons.begin(), wall.polygons.end());
        const Mended m = mend_whole(mesh);
        EXPECT_EQ(m.repairs.solid_parts, m.repairs.parts);
        EXPECT_EQ(m.repairs.caps, 0u);
        EXPECT_EQ(m.repairs.hidden, wall.polygons.size());
        EXPECT_NEAR(mass_by_volume(m.solid.soup).measure, 2, 1e-12 + 20 * by);
      }
  }
}

}  // namespace
}  // namespace sonde
