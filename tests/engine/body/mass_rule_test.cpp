// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/mass_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/queries/body_queries.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using testing::EndsWith;
using testing::StartsWith;

/// A rectangle in z = 0 of n × n cells, about the origin.
PolygonSoup rectangle(double a, double b, int n) {
  PolygonSoup out;
  const auto steps = static_cast<std::size_t>(n);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      out.points.emplace_back(a * (i / double(n) - 0.5), b * (j / double(n) - 0.5), 0);
  for (std::size_t i = 0; i < steps; ++i)
    for (std::size_t j = 0; j < steps; ++j) {
      const std::size_t at = i * (steps + 1) + j;
      out.polygons.push_back({at, at + steps + 1, at + steps + 2, at + 1});
    }
  return out;
}

/// A box whose top is open, its bottom in z = 0.
PolygonSoup tray(double a, double b, double high) {
  return test::placed(
      test::without(test::box({a, b, high}), [=](const Vec3& x) { return x.z() > 0.49 * high; }),
      {0, 0, high / 2});
}

/// A tube of n flat sides, open at both ends, from z = 0 on.
PolygonSoup tube(double radius, double length, int n) {
  const PolygonSoup rod = test::lathed({{0, 0}, {radius, 0}, {radius, length}, {0, length}}, n);
  return test::without(
      rod, [=](const Vec3& x) { return x.z() < 0.01 * length || x.z() > 0.99 * length; });
}

/// A sheet, with its area and its middle.
struct Sheet {
  PolygonSoup mesh;
  double area;
  Vec3 middle;
};
std::vector<Sheet> sheets() {
  const auto open_box = [](double a, double b, double h) {
    const double sides = 2 * (a + b) * h, all = a * b + sides;
    return Sheet{tray(a, b, h), all, {0, 0, sides * h / 2 / all}};
  };
  const int n = 12;
  return {{rectangle(2, 1, 1), 2, Vec3::Zero()},
          {rectangle(0.5, 3, 7), 1.5, Vec3::Zero()},
          open_box(1, 1, 0.3),
          open_box(3, 1, 0.05),
          {tube(0.5, 2, n), n * std::sin(test::two_pi / 2 / n) * 2, {0, 0, 1}}};
}

// Reference: areas and middles of rectangles and regular polygons' sides, by hand.
TEST(MassRule, a_sheet_with_a_small_closed_part_has_the_mass_of_all_of_its_surface) {
  for (const Sheet& sheet : sheets())
    for (const double side : {0.002, 0.1})
      for (const bool over : {false, true}) {
        const Vec3 at(0.3, -0.2, 4);
        const PolygonSoup cube = test::placed(test::box({side, side, side}), at);
        const auto body =
            test::body(test::joined(sheet.mesh, over ? test::turned_over(cube) : cube));
        const double more = 6 * side * side, all = sheet.area + more;
        EXPECT_TRUE(body->solid) << body->why;
        EXPECT_FALSE(body->mass.by_volume);
        EXPECT_NEAR(body->mass.measure, all, 1e-12 * all);
        EXPECT_LT((body->mass.com - (sheet.area * sheet.middle + more * at) / all).norm(), 1e-12);
        EXPECT_THAT(body->mass_why, StartsWith("by area: "));
        EXPECT_THAT(body->mass_why, EndsWith(" % of the area belongs to open parts"));
        // The inside of the closed part still counts.
        EXPECT_TRUE(inside(*body, at));
        EXPECT_FALSE(inside(*body, sheet.middle + Vec3(0.01, 0.02, 0.01)));
      }
}

// Reference: the moments of a rectangle, a² / 12 and b² / 12, and of the surface of a cube, 5 s² /
// 18 about each axis through its middle.
TEST(MassRule, its_moments_are_those_of_the_surface) {
  for (const int n : {1, 5})
    for (const double side : {0.02, 0.3, 0.7}) {
      const double a = 2, b = 1, more = 6 * side * side, all = a * b + more;
      const auto body =
          test::body(test::joined(rectangle(a, b, n), test::box({side, side, side}), {0, 0, 2}));
      const double apart = a * b * more / (all * all) * 4, own = more / all * 5 * side * side / 18;
      Vec3 moments(a * b / all * b * b / 12 + own + apart, a * b / all * a * a / 12 + own + apart,
                   a * b / all * (a * a + b * b) / 12 + own);
      std::sort(moments.data(), moments.data() + 3);
      EXPECT_LT((body->mass.inertia - moments).norm(), 1e-12);
    }
}

// Reference: a cube of 1 has an area of 6.
TEST(MassRule, a_hundredth_of_the_area_is_where_it_changes) {
  const PolygonSoup cube = test::box({1, 1, 1}), fine = test::cut_beyond(cube, {0, 0, 1}, -9);
  for (const PolygonSoup& closed : {cube, fine, test::turned_over(fine)})
    for (const double share : {0.002, 0.0099, 0.0101, 0.3}) {
      const double area = share / (1 - share) * 6, side = std::sqrt(area);
      const auto body =
          test::body(test::joined(closed, rectangle(side / 2, 2 * side, 3), {0, 0, 3}));
      const bool by_area = share > 0.01;
      EXPECT_TRUE(body->solid);
      EXPECT_EQ(body->mass.by_volume, !by_area) << share;
      EXPECT_NEAR(body->mass.measure, by_area ? 6 + area : 1, 1e-12);
      EXPECT_NEAR(body->mass.com.z(), by_area ? 3 * area / (6 + area) : 0, 1e-12);
      EXPECT_THAT(body->mass_why,
                  StartsWith(by_area ? "by area: " : "by volume of the closed parts: "));
    }
}

TEST(MassRule, what_is_closed_or_open_throughout_says_nothing) {
  for (const PolygonSoup& mesh :
       {test::box({1, 2, 3}), test::joined(test::box({1, 1, 1}), test::box({1, 1, 1}), {0.5, 0, 0}),
        rectangle(1, 2, 3), tray(1, 1, 0.5)})
    EXPECT_EQ(test::body(mesh)->mass_why, "");
}

// A fin that is there both ways round, at an edge of a cube; and a sheet that is there twice.
TEST(MassRule, each_triangle_counts_once) {
  const PolygonSoup cube = test::box({1, 1, 1});
  for (const double wide : {0.5, 2.0, 7.0}) {
    PolygonSoup fin{
        {{0.5, -0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5 + wide, 0.5, 0.5}, {0.5 + wide, -0.5, 0.5}},
        {{0, 1, 2}, {0, 2, 3}}};
    const PolygonSoup both = test::joined(fin, test::turned_over(fin)),
                      twice = test::joined(fin, fin);
    for (const PolygonSoup& sheet : {fin, both, twice}) {
      const auto body = test::body(test::joined(cube, sheet));
      EXPECT_TRUE(body->solid);
      EXPECT_NEAR(body->mass.measure, 6 + wide, 1e-12) << body->mass_why;
    }
  }
}

TEST(MassRule, a_mass_that_was_given_needs_no_reason) {
  const auto body =
      test::body(test::joined(rectangle(1, 1, 1), test::box({0.1, 0.1, 0.1}), {0, 0, 1}));
  EXPECT_EQ(with_other_mass(*body, body->mass)->mass_why, "");
}

}  // namespace
}  // namespace sonde
