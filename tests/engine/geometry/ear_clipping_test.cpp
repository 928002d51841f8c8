// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons of many corners. References: the shoelace formula, and that n corners make n − 2
// triangles; a polygon that does not cross itself is covered by triangles that all face its way.
#include "engine/geometry/ear_clipping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace sonde {
namespace {

using Outline = std::vector<Eigen::Vector2d>;
constexpr std::size_t many = 50'000;

double twice_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

double shoelace(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < outline.size(); ++i)
    twice += twice_area(outline[0], outline[i], outline[i + 1]);
  return twice / 2;
}

std::vector<Triangle> clipped(const Outline& outline) {
  std::vector<std::size_t> polygon(outline.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  std::vector<Triangle> out;
  clip_ears(polygon, outline, out);
  return out;
}

/// The area by sign, and that without: the same where no triangle faces the other way.
void expect_area(const Outline& outline, const std::vector<Triangle>& triangles, bool covered) {
  double area = 0, size = 0;
  for (const Triangle& t : triangles) {
    const double twice = twice_area(outline[t[0]], outline[t[1]], outline[t[2]]);
    area += twice / 2, size += std::abs(twice) / 2;
  }
  EXPECT_EQ(triangles.size(), outline.size() - 2);
  EXPECT_NEAR(area, shoelace(outline), 1e-9 * size);
  if (covered) {
    EXPECT_NEAR(size, shoelace(outline), 1e-9 * size);
  }
}

Outline star(std::size_t corners) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> radius(0.1, 1);
  Outline out;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle =
        2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    const double r = radius(random);
    out.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return out;
}

Outline comb(std::size_t corners) {
  Outline out{{0, -1}, {2, -1}};
  const auto teeth = static_cast<double>(corners / 4);
  for (double i = teeth; i-- > 0;)
    for (const auto& [x, y] : {std::pair{2.0, 0.0}, {1.5, 1.0}, {1.0, 1.0}, {0.5, 0.0}})
      out.emplace_back((2 * i + x) / teeth, y);
  return out;
}

/// A band that winds inwards, out along one side and back along the other.
Outline spiral(std::size_t corners) {
  const std::size_t half = corners / 2;
  Outline out;
  const auto at = [&](std::size_t i, double width) {
    const double along = static_cast<double>(i) / static_cast<double>(half);
    const double angle = 2 * std::numbers::pi * 20 * along, r = 1 - 0.9 * along + width;
    return Eigen::Vector2d(r * std::cos(angle), r * std::sin(angle));
  };
  for (std::size_t i = 0; i < half; ++i) out.push_back(at(i, 0));
  for (std::size_t i = half; i-- > 0;) out.push_back(at(i, -0.02));
  return out;
}

TEST(EarClipping, many_corners_that_do_not_cross_are_covered_once) {
  for (const Outline& outline : {star(many), comb(many), spiral(many)})
    expect_area(outline, clipped(outline), true);
}

// What took more than 20 s before: every corner was compared with every other, for each cut.
TEST(EarClipping, many_corners_that_cross_themselves_keep_their_area) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> at(-1, 1);
  Outline wild, pentagram;
  for (std::size_t i = 0; i < many; ++i) {
    wild.emplace_back(at(random), at(random));
    const double angle = 2 * std::numbers::pi * 0.4 * static_cast<double>(i);
    const double r = 1 - 0.5 * static_cast<double>(i) / many;
    pentagram.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  for (const Outline& outline : {wild, pentagram}) expect_area(outline, clipped(outline), false);
}

TEST(EarClipping, a_crossing_polygon_is_the_same_at_any_place_in_a_mesh) {
  const Outline bow{{0, 0}, {1, 1}, {1, 0}, {0, 1}, {0.5, 2}};
  std::vector<Triangle> out;
  clip_ears({7, 3, 9, 4, 1}, bow, out);
  for (const Triangle& t : out)
    for (const std::uint32_t corner : t)
      EXPECT_TRUE(corner == 7 || corner == 3 || corner == 9 || corner == 4 || corner == 1);
  EXPECT_EQ(out.size(), 3U);
}

}  // namespace
}  // namespace sonde
