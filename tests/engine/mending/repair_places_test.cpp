// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/repair_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/mending/mend.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::vector<RepairPlace> places_of(const PolygonSoup& mesh, Model asked = Model::automatic) {
  const Soup soup = compacted(triangulate_all(mesh));
  Mended mended = mend(soup, analyse_topology(soup), asked, "a.off");
  sort_and_cap(mended.places);
  EXPECT_EQ(mended.places.all, mended.places.places.size());
  return mended.places.places;
}

Vec3 middle_of(const PolygonSoup& soup, const Polygon& t) {
  return (soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]]) / 3;
}

/// The mesh with the triangles turned whose middles lie so near to those points.
PolygonSoup turned_near(PolygonSoup mesh, const std::vector<Vec3>& points, double near) {
  for (Polygon& t : mesh.polygons)
    for (const Vec3& point : points)
      if ((middle_of(mesh, t) - point).norm() < near) {
        std::swap(t[1], t[2]);
        break;
      }
  return mesh;
}

TEST(RepairPlaces, a_sound_mesh_has_none) {
  EXPECT_TRUE(places_of(test::icosphere(1, 2)).empty());
  EXPECT_TRUE(
      places_of(test::joined(test::icosphere(1, 1), test::icosphere(1, 1), {3, 0, 0})).empty());
}

TEST(RepairPlaces, a_patch_of_turned_triangles_is_one_place_and_another_patch_another) {
  const std::vector<Vec3> points{Vec3(0, 0, 1), Vec3(1, 0, 0)};
  const auto places = places_of(turned_near(test::icosphere(1, 3), points, 0.2));
  ASSERT_EQ(places.size(), 2u);
  for (const Vec3& point : points) {
    const bool found = std::ranges::any_of(places, [&](const RepairPlace& p) {
      return p.kind == RepairKind::turned && (p.at - point).norm() < 0.1 && p.size > 0.1 &&
             p.size < 0.5 && p.outward.dot(point) > 0.95;
    });
    EXPECT_TRUE(found) << point.transpose();
  }
}

TEST(RepairPlaces, each_cap_is_one_and_knows_its_outside) {
  const auto places = places_of(test::without(test::icosphere(2, 3), [](const Vec3& x) {
    return (x - Vec3(0, 0, 2)).norm() < 0.25 || (x + Vec3(0, 0, 2)).norm() < 0.25;
  }));
  ASSERT_EQ(places.size(), 2u);
  for (const RepairPlace& p : places) {
    EXPECT_EQ(p.kind, RepairKind::cap);
    EXPECT_NEAR(std::abs(p.at.z()), 2, 0.1);
    EXPECT_GT(p.outward.dot(p.at), 1.9);
  }
}

TEST(RepairPlaces, also_of_a_mesh_that_was_inside_out) {
  const auto places = places_of(test::turned_over(test::without(
      test::icosphere(1, 3), [](const Vec3& x) { return (x - Vec3(0, 0, 1)).norm() < 0.12; })));
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0].kind, RepairKind::cap);
  EXPECT_GT(places[0].outward.z(), 0.9);
  EXPECT_EQ(places[1].kind, RepairKind::inside_out);
  EXPECT_LT(places[1].at.norm(), 0.1) << "all of it";
  EXPECT_GT(places[1].size, 1);
}

TEST(RepairPlaces, a_crack_is_one_seam_however_many_corners_it_has) {
  const auto cut = places_of(test::cut_beyond(test::box({1, 1, 1}), Vec3::UnitX(), 0.4));
  ASSERT_EQ(cut.size(), 1u);
  EXPECT_EQ(cut[0].kind, RepairKind::seam);
  EXPECT_NEAR(cut[0].at.x(), 0.5, 1e-12);
  const auto cracked = places_of(test::cracked(test::icosphere(1, 2), 1e-7, 3));
  ASSERT_EQ(cracked.size(), 1u);
  EXPECT_EQ(cracked[0].kind, RepairKind::seam);
  EXPECT_EQ(cracked[0].outward, Vec3::Zero()) << "it is all around";
}

TEST(RepairPlaces, what_is_there_twice_is_shown_where_it_is) {
  const PolygonSoup ball = test::icosphere(1, 2);
  PolygonSoup twice = test::icosphere(0.5, 1);
  const std::vector<Polygon> once = twice.polygons;
  twice.polygons.insert(twice.polygons.end(), once.begin(), once.end());
  const auto places = places_of(test::joined(ball, twice, {3, 0, 0}));
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places[0].kind, RepairKind::repeated);
  EXPECT_LT((places[0].at - Vec3(3, 0, 0)).norm(), 1e-12);
  EXPECT_GE(places[0].size, 0.5);
}

TEST(RepairPlaces, a_surface_that_is_left_as_it_is_has_none_until_it_is_closed) {
  const PolygonSoup open =
      test::without(test::box({1, 1, 1}), [](const Vec3& x) { return x.z() > 0.49; });
  EXPECT_TRUE(places_of(open).empty());
  const auto closed = places_of(open, Model::solid);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_NEAR((closed[0].at - Vec3(0, 0, 0.5)).norm(), 0, 1e-12);
  EXPECT_NEAR(closed[0].size, std::sqrt(0.5), 1e-12);
}

TEST(RepairPlaces, of_very_many_the_largest_stay_and_all_are_counted) {
  RepairPlaces many;
  for (int i = 0; i < 20'000; ++i)
    many.places.push_back(
        {i % 40 == 0 ? RepairKind::cap : RepairKind::seam, Vec3(i, 0, 0), double(i), Vec3::Zero()});
  sort_and_cap(many);
  EXPECT_EQ(many.all, 20'000u);
  ASSERT_EQ(many.places.size(), RepairPlaces::most);
  for (std::size_t i = 0; i < 500; ++i) EXPECT_EQ(many.places[i].kind, RepairKind::cap);
  EXPECT_EQ(many.places[0].size, 19'960);
  EXPECT_EQ(many.places[500].kind, RepairKind::seam);
  EXPECT_EQ(many.places[500].size, 19'999);
}

}  // namespace
}  // namespace sonde
