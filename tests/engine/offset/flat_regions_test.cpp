// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/flat_regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "tests/engine/offset/prisms.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using Corners3 = std::array<std::uint32_t, 3>;

struct Flats {
  Soup soup;
  Fans fans;
  std::vector<Vec3> normals;
  std::vector<char> has_say;
  std::vector<double> tilts;
  explicit Flats(const PolygonSoup& polygons)
      : soup(triangulate_all(polygons)), fans(find_fans(soup, 0)) {
    for (const Triangle& t : soup.triangles) {
      const Vec3& a = soup.vertices[t[0]];
      normals.push_back((soup.vertices[t[1]] - a).cross(soup.vertices[t[2]] - a).normalized());
    }
    has_say.assign(soup.triangles.size(), 1);
    tilts.assign(soup.triangles.size(), 1e-5);
  }
  FlatRegions regions() const { return {fans, normals, has_say, tilts}; }
};

// Reference: by hand. The normals of a prism's faces tell which of its triangles are in one.
TEST(FlatRegions, of_a_prism_are_its_faces) {
  const Flats flats(test::prism(test::regular(7, 1), 2));
  const FlatRegions regions = flats.regions();
  std::map<std::uint32_t, std::size_t> sizes;
  for (std::uint32_t s = 0; s < flats.normals.size(); ++s) {
    ++sizes[regions.of(s)];
    for (std::uint32_t t = 0; t < flats.normals.size(); ++t)
      EXPECT_EQ(regions.of(s) == regions.of(t),
                (flats.normals[s] - flats.normals[t]).norm() < 1e-9);
    const auto same = regions.triangles(regions.of(s));
    EXPECT_TRUE(std::ranges::find(same, s) != same.end());
    for (const std::uint32_t t : same) EXPECT_EQ(regions.of(t), regions.of(s));
  }
  EXPECT_EQ(sizes.size(), 9u);
  for (const auto& [region, size] : sizes) EXPECT_EQ(regions.triangles(region).size(), size);
}

TEST(FlatRegions, faces_that_look_the_same_way_but_do_not_hang_together_are_two) {
  const Flats flats(test::together(test::box({1, 1, 1}), test::box({1, 1, 1}), {3, 0, 0}));
  const FlatRegions regions = flats.regions();
  std::set<std::uint32_t> all;
  for (std::uint32_t t = 0; t < flats.normals.size(); ++t) all.insert(regions.of(t));
  EXPECT_EQ(all.size(), 12u);
}

// Reference: the corners of the triangle on the other side.
TEST(FlatRegions, across_a_side_is_the_triangle_that_has_it_too) {
  const Flats flats(test::torus(1, 0.3, 8, 6));
  const FlatRegions regions = flats.regions();
  for (std::uint32_t t = 0; t < flats.fans.of.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto other = regions.across(t, k);
      ASSERT_TRUE(other);
      EXPECT_NE(*other, t);
      const Corners3& there = flats.fans.of[*other];
      for (const std::size_t end : {k, (k + 1) % 3})
        EXPECT_TRUE(std::ranges::find(there, flats.fans.of[t][end]) != there.end());
    }
  const Flats open({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  for (std::size_t k = 0; k < 3; ++k) EXPECT_FALSE(open.regions().across(0, k));
  // Three triangles at one side: none is the one on the other side.
  const Fans three{{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {0, 1, 2, 3, 4}, {}};
  const FlatRegions at_one(three, std::vector<Vec3>(3, Vec3::UnitZ()), {1, 1, 1},
                           {1e-5, 1e-5, 1e-5});
  for (std::uint32_t t = 0; t < 3; ++t) EXPECT_FALSE(at_one.across(t, 0));
}

// Reference: by hand. A strip of triangles bends by 1e-3 from one to the next: those within the
// tilt of the seed are one region, and those without a say join it but lead no further.
TEST(FlatRegions, a_region_reaches_as_far_as_the_tilt_of_its_seed_allows) {
  PolygonSoup strip;
  for (int i = 0; i < 8; ++i) strip.points.emplace_back(i, i % 2, 0);
  for (std::size_t i = 0; i + 2 < 8; ++i)
    strip.polygons.push_back(i % 2 ? Polygon{i + 1, i, i + 2} : Polygon{i, i + 1, i + 2});
  Flats flats(strip);
  for (std::size_t i = 0; i < flats.normals.size(); ++i)
    flats.normals[i] = Vec3(1e-3 * double(i), 0, 1).normalized();
  const auto sizes = [&] {
    const FlatRegions regions = flats.regions();
    std::vector<std::size_t> out;
    for (std::uint32_t t = 0; t < flats.normals.size();
         t += std::uint32_t(regions.triangles(regions.of(t)).size()))
      out.push_back(regions.triangles(regions.of(t)).size());
    return out;
  };
  flats.tilts.assign(6, 2.5e-3);
  EXPECT_EQ(sizes(), (std::vector<std::size_t>{3, 3}));
  flats.tilts.assign(6, 1e-5);
  EXPECT_EQ(sizes(), (std::vector<std::size_t>{1, 1, 1, 1, 1, 1}));
  flats.tilts.assign(6, 1e-1);
  EXPECT_EQ(sizes(), (std::vector<std::size_t>{6}));
  flats.has_say[2] = 0;
  EXPECT_EQ(sizes(), (std::vector<std::size_t>{3, 3}));
}

// Reference: by hand. Two triangles of a square have its four sides, the same way round.
TEST(FlatRegions, the_outline_is_what_no_other_has_the_other_way_round) {
  EXPECT_EQ(outline_of({{0, 1, 2}, {0, 2, 3}}),
            (std::vector<FanSide>{{0, 1}, {3, 0}, {1, 2}, {2, 3}}));
  EXPECT_TRUE(outline_of({}).empty());
  EXPECT_TRUE(outline_of({{0, 1, 2}, {0, 2, 1}}).empty());
  // A side of a triangle that has become one corner is none.
  EXPECT_TRUE(outline_of({{0, 0, 1}}).empty());
  EXPECT_EQ(outline_of({{0, 1, 2}, {0, 1, 3}}).size(), 6u);  // the same way round: it counts twice
}

double area_of(const std::vector<Corners3>& triangles, const std::vector<Vec3>& places,
               const Vec3& normal) {
  double area = 0;
  for (const Corners3& t : triangles)
    area += 0.5 * normal.dot((places[t[1]] - places[t[0]]).cross(places[t[2]] - places[t[0]]));
  return area;
}

// Reference: the area of the outline, and that its own outline is the same again.
TEST(FlatRegions, an_outline_is_filled_by_its_corners_alone) {
  std::mt19937_64 random(1);
  const Quat q = test::random_rotation(random);
  const Vec3 up = q * Vec3::UnitZ(), from(0.3, -0.2, 0.7);
  // A square with a square hole in it, of places among others.
  std::vector<Vec3> places(3, Vec3::Zero());
  std::vector<FanSide> outline;
  for (const double half : {2.0, 0.5}) {
    const auto first = std::uint32_t(places.size());
    for (const auto& x : test::rectangle(2 * half, 2 * half))
      places.push_back(from + q * Vec3(x.x(), x.y(), 0));
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t a = first + i, b = first + (i + 1) % 4;
      outline.push_back(half > 1 ? FanSide{a, b} : FanSide{b, a});
    }
  }
  const auto found = filled(outline, places, up);
  ASSERT_TRUE(found);
  EXPECT_NEAR(area_of(*found, places, up), 16 - 1, 1e-12);
  for (const Corners3& t : *found) EXPECT_GT(area_of({t}, places, up), 0);
  std::vector<FanSide> again = outline_of(*found);
  std::ranges::sort(again);
  std::ranges::sort(outline);
  EXPECT_EQ(again, outline);
}

TEST(FlatRegions, an_outline_that_crosses_itself_or_is_turned_over_is_not_filled) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<FanSide> around{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  EXPECT_TRUE(filled(around, square, Vec3::UnitZ()));
  EXPECT_FALSE(filled(around, square, -Vec3::UnitZ()));
  // A corner that has gone over the side opposite: more within than against it, but crossed.
  std::vector<Vec3> crossed = square;
  crossed[3] = {0.8, -0.5, 0};
  EXPECT_FALSE(filled(around, crossed, Vec3::UnitZ()));
  const auto nothing = filled({}, square, Vec3::UnitZ());
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing->empty());
}

}  // namespace
}  // namespace sonde
