// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/mend.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/geometry/mass_integrals.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Mended mended(const PolygonSoup& mesh, Model asked = Model::automatic) {
  const Soup soup = compacted(triangulate_all(mesh));
  return mend(soup, analyse_topology(soup), asked, "a.off");
}

std::ptrdiff_t count(const Mended& m, TriangleKind kind) {
  return std::count(m.kinds.begin(), m.kinds.end(), kind);
}

TEST(Mend, sound_parts_are_as_they_were_given) {
  const Mended m = mended(test::joined(test::box({1, 1, 1}), test::icosphere(1, 1), {5, 0, 0}));
  EXPECT_TRUE(m.as_given);
  EXPECT_FALSE(m.cracked);
  EXPECT_FALSE(m.repairs.any());
  EXPECT_EQ(m.why, "closed: the inside counts");
  EXPECT_EQ(m.repairs.solid_parts, 2u);
}

// Reference: the mesh before its corners were moved apart.
TEST(Mend, cracks_of_the_size_of_the_reach_leave_one_part) {
  for (const PolygonSoup& mesh : {test::icosphere(1, 2), test::icosphere(30, 1),
                                  test::torus(1, 0.3, 24, 12), test::box({1, 2, 3})})
    for (const std::uint64_t seed : {1, 2, 3}) {
      Eigen::AlignedBox3d box;
      for (const Vec3& x : mesh.points) box.extend(x);
      const Mended m = mended(test::cracked(mesh, 8.7e-6 * box.sizes().norm(), seed));
      EXPECT_EQ(m.repairs.solid_parts, 1u);
      EXPECT_EQ(m.repairs.parts, 1u) << m.why;
      EXPECT_EQ(m.repairs.caps, 0u);
      const double volume = mass_by_volume(test::soup_of(mesh)).measure;
      EXPECT_NEAR(mass_by_volume(m.solid.soup).measure, volume, 1e-3 * volume);
    }
}

TEST(Mend, a_sheet_beside_a_solid_is_loose) {
  const PolygonSoup sheet =
      test::without(test::box({9, 9, 1}), [](const Vec3& x) { return x.z() > -0.49; });
  const Mended m = mended(test::joined(test::icosphere(1, 2), sheet, {0, 0, -2}));
  EXPECT_EQ(count(m, TriangleKind::loose), 2);
  EXPECT_EQ(count(m, TriangleKind::bounds), 320);
  EXPECT_EQ(m.why, "1 of 2 parts is closed: its inside counts");
}

TEST(Mend, an_inner_wall_is_left_out_and_a_fin_is_not) {
  const PolygonSoup box = test::box({1, 1, 1});
  EXPECT_EQ(count(mended(test::joined(box, box, {1, 0, 0})), TriangleKind::hidden), 4);
  PolygonSoup finned = test::triangulated(box);
  finned.points.emplace_back(0, 0, 3);
  finned.polygons.push_back({4, 5, 8});
  finned.polygons.push_back({5, 4, 8});
  const Mended m = mended(finned);
  EXPECT_EQ(count(m, TriangleKind::hidden), 0);
  EXPECT_EQ(count(m, TriangleKind::bounds), 14);
}

TEST(Mend, both_sides_of_a_solid_count_as_one) {
  for (const PolygonSoup& one : {test::icosphere(1, 2), test::box({1, 2, 3})}) {
    PolygonSoup both{one.points, {}};
    for (const Polygon& polygon : test::triangulated(one).polygons) {
      both.polygons.push_back(polygon);
      both.polygons.push_back({polygon[0], polygon[2], polygon[1]});
    }
    const Mended m = mended(both);
    EXPECT_EQ(m.triangles.size(), both.polygons.size() / 2);
    EXPECT_EQ(m.repairs.solid_parts, 1u);
    EXPECT_GT(mass_by_volume(m.solid.soup).measure, 0);
  }
}

TEST(Mend, a_surface_is_left_as_it_is) {
  const PolygonSoup open =
      test::without(test::box({1, 1, 1}), [](const Vec3& x) { return x.z() > 0.49; });
  const Mended m = mended(open);
  EXPECT_TRUE(m.as_given);
  EXPECT_TRUE(m.solid.soup.triangles.empty());
  EXPECT_FALSE(m.repairs.any());
  EXPECT_THAT(m.why, testing::HasSubstr("4 open edges, open mouth 1"));
  // Asked for, its inside counts.
  const Mended solid = mended(open, Model::solid);
  EXPECT_EQ(count(solid, TriangleKind::cap), 2);
  EXPECT_NEAR(mass_by_volume(solid.solid.soup).measure, 1, 1e-14);
}

// Beside a large solid that is whole, and a sheet with open edges of its own.
TEST(Mend, the_open_edges_that_are_said_are_those_of_the_part) {
  const PolygonSoup vessel =
      test::without(test::box({1, 1, 1}), [](const Vec3& x) { return x.z() > 0.49; });
  const PolygonSoup sheet =
      test::without(test::box({0.5, 0.5, 0.1}), [](const Vec3& x) { return x.z() > -0.04; });
  const Mended m = mended(
      test::joined(test::joined(test::icosphere(1, 2), vessel, {3, 0, 0}), sheet, {0, 0, 3}));
  EXPECT_THAT(m.why, testing::StartsWith("1 of 3 parts is closed: its inside counts; the largest "
                                         "other has 4 open edges, open mouth 1"));
}

// Twenty thousand triangles, each cut off from the others by a corner on each side.
TEST(Mend, it_says_where_corners_on_edges_were_not_looked_for) {
  PolygonSoup mesh = test::icosphere(1, 0);
  for (int k = 0; k < 5; ++k) mesh = test::cut_beyond(mesh, Vec3::UnitX(), -9);
  const Mended m = mended(test::cut_here_and_there(mesh, 2, 0, 1));
  EXPECT_GT(m.repairs.unsearched, seam_tuning.most_open);
  EXPECT_THAT(m.why, testing::HasSubstr("corners on open edges were not looked for"));
  const Mended few = mended(test::cut_here_and_there(test::icosphere(1, 2), 2, 0, 1));
  EXPECT_EQ(few.repairs.unsearched, 0u);
  EXPECT_THAT(few.why, testing::Not(testing::HasSubstr("looked for")));
}

TEST(Mend, what_has_no_inside_cannot_be_a_solid) {
  const PolygonSoup sheet =
      test::without(test::box({1, 1, 1}), [](const Vec3& x) { return x.z() < 0.49; });
  try {
    mended(sheet, Model::solid);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "a.off: cannot be a solid: 4 open edges");
  }
}

}  // namespace
}  // namespace sonde
