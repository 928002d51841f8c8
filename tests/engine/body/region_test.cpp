// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace sonde {
namespace {

using Points = std::vector<std::array<double, 2>>;

/// Adds a closed polygon to a region.
void add_loop(PlanarRegion& region, const Points& points) {
  const auto first = static_cast<std::uint32_t>(region.points.size());
  const auto n = static_cast<std::uint32_t>(points.size());
  region.points.insert(region.points.end(), points.begin(), points.end());
  for (std::uint32_t i = 0; i < n; ++i) region.outline.emplace_back(first + i, first + (i + 1) % n);
}

Points square(double half, double x = 0, double y = 0) {
  return {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
}

double twice_area(const PlanarRegion& region, const std::array<std::uint32_t, 3>& t) {
  const auto &a = region.points[t[0]], &b = region.points[t[1]], &c = region.points[t[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Checks that all triangles are anticlockwise, and returns their area.
double area(const PlanarRegion& region) {
  const auto triangles = triangulate(region);
  if (!triangles) {
    ADD_FAILURE() << "no triangles";
    return 0;
  }
  double sum = 0;
  for (const auto& t : *triangles) {
    EXPECT_GT(twice_area(region, t), 0);
    sum += twice_area(region, t) / 2;
  }
  return sum;
}

bool covers(const PlanarRegion& region, double x, double y) {
  PlanarRegion with = region;
  with.points.push_back({x, y});
  const auto at = static_cast<std::uint32_t>(region.points.size());
  const auto triangles = triangulate(region).value();
  for (const auto& [i, j, k] : triangles)
    if (twice_area(with, {i, j, at}) >= 0 && twice_area(with, {j, k, at}) >= 0 &&
        twice_area(with, {k, i, at}) >= 0)
      return true;
  return false;
}

TEST(Region, square_is_two_triangles) {
  PlanarRegion region;
  add_loop(region, square(1));
  EXPECT_EQ(triangulate(region)->size(), 2u);
  EXPECT_EQ(area(region), 4);
}

// Closed forms: the areas of squares; a polygon of n corners with h holes takes n + 2h - 2.
TEST(Region, holes_are_left_out) {
  PlanarRegion region;
  add_loop(region, square(1));
  add_loop(region, square(0.25, 0.5, 0.5));
  EXPECT_EQ(triangulate(region)->size(), 8u);
  EXPECT_EQ(area(region), 3.75);
  EXPECT_FALSE(covers(region, 0.5, 0.5));
  EXPECT_TRUE(covers(region, -0.5, -0.5));
  add_loop(region, square(0.25, -0.5, -0.5));
  EXPECT_EQ(triangulate(region)->size(), 14u);
  EXPECT_EQ(area(region), 3.5);
}

TEST(Region, what_is_nested_is_inside_by_turns) {
  PlanarRegion region;
  double expected = 0;
  for (int i = 0; i < 6; ++i) {
    const double half = 6 - i;
    add_loop(region, square(half));
    expected += (i % 2 ? -1 : 1) * 4 * half * half;
    EXPECT_EQ(area(region), expected);
    EXPECT_EQ(covers(region, 0.1, 0.2), i % 2 == 0);
  }
}

TEST(Region, may_touch_itself_at_a_corner) {
  // Two squares with one corner in common.
  PlanarRegion apart;
  apart.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}, {2, 2}, {1, 2}};
  apart.outline = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 4}, {4, 5}, {5, 6}, {6, 2}};
  EXPECT_EQ(triangulate(apart)->size(), 4u);
  EXPECT_EQ(area(apart), 2);
  // A hole that reaches a corner of the outline.
  PlanarRegion hole;
  hole.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}, {1, 2}};
  hole.outline = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {4, 5}, {5, 0}};
  EXPECT_EQ(area(hole), 16 - 1.5);
}

TEST(Region, the_direction_and_order_of_segments_do_not_matter) {
  PlanarRegion region;
  add_loop(region, square(1));
  add_loop(region, square(0.5));
  std::mt19937_64 random(1);
  for (int i = 0; i < 20; ++i) {
    std::shuffle(region.outline.begin(), region.outline.end(), random);
    for (auto& [a, b] : region.outline)
      if (random() % 2) std::swap(a, b);
    EXPECT_EQ(area(region), 3);
  }
}

TEST(Region, crossing_segments_are_refused) {
  PlanarRegion bow_tie;
  add_loop(bow_tie, {{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  EXPECT_FALSE(triangulate(bow_tie));
  PlanarRegion two;
  add_loop(two, square(1));
  add_loop(two, square(1, 0.5, 0.5));
  EXPECT_FALSE(triangulate(two));
}

TEST(Region, points_in_one_place_are_refused) {
  PlanarRegion region;
  add_loop(region, square(1));
  add_loop(region, {{1, 1}, {2, 1}, {2, 2}});
  EXPECT_FALSE(triangulate(region));
}

TEST(Region, overlapping_segments_are_refused) {
  // A corner in the middle of a side.
  PlanarRegion touching;
  add_loop(touching, square(1));
  add_loop(touching, {{1, 0}, {2, -0.5}, {2, 0.5}});
  EXPECT_FALSE(triangulate(touching));
  // Two sides that lie along each other.
  PlanarRegion beside;
  add_loop(beside, square(1));
  add_loop(beside, {{1, -0.5}, {2, -0.5}, {2, 0.5}, {1, 0.5}});
  EXPECT_FALSE(triangulate(beside));
  // One side twice.
  PlanarRegion twice;
  add_loop(twice, square(1));
  twice.outline.emplace_back(1, 0);
  EXPECT_FALSE(triangulate(twice));
}

TEST(Region, an_outline_that_encloses_nothing_is_refused) {
  EXPECT_FALSE(triangulate(PlanarRegion{}));
  EXPECT_FALSE(triangulate(PlanarRegion{.points = {{1, 2}}, .outline = {}}));
  EXPECT_FALSE(triangulate(PlanarRegion{.points = {{0, 0}, {1, 0}}, .outline = {{0, 1}}}));
  EXPECT_FALSE(
      triangulate(PlanarRegion{.points = {{0, 0}, {1, 1}, {2, 2}}, .outline = {{0, 1}, {1, 2}}}));
}

// Closed form: the shoelace formula of a star of many corners.
TEST(Region, many_corners) {
  std::mt19937_64 random(2);
  for (const int n : {3, 10, 100, 1000}) {
    Points star;
    double expected = 0;
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      const double r = 1 + static_cast<double>(random() % 1000) / 1000;
      star.push_back({r * std::cos(a), r * std::sin(a)});
    }
    for (std::size_t i = 0; i < star.size(); ++i) {
      const auto &p = star[i], &q = star[(i + 1) % star.size()];
      expected += (p[0] * q[1] - p[1] * q[0]) / 2;
    }
    PlanarRegion region;
    add_loop(region, star);
    EXPECT_EQ(triangulate(region)->size(), star.size() - 2);
    EXPECT_NEAR(area(region), expected, 1e-12 * expected);
  }
}

TEST(Region, same_bits_twice) {
  PlanarRegion region;
  add_loop(region, square(1));
  add_loop(region, square(0.3, 0.1, 0.2));
  EXPECT_EQ(triangulate(region), triangulate(region));
}

}  // namespace
}  // namespace sonde
