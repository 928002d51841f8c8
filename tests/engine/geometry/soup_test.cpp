// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/soup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "engine/geometry/topology.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using FlatOutline = std::vector<std::pair<double, double>>;

PolygonSoup one_polygon(const FlatOutline& outline) {
  PolygonSoup out;
  out.polygons.emplace_back();
  for (const auto& [x, y] : outline) {
    out.polygons[0].push_back(out.points.size());
    out.points.emplace_back(x, y, 0);
  }
  return out;
}

PolygonSoup moved(PolygonSoup soup, const Quat& q, const Vec3& p) {
  for (Vec3& x : soup.points) x = q * x + p;
  return soup;
}

double area_by_shoelace(const FlatOutline& o) {
  double twice = 0;
  for (std::size_t i = 0; i < o.size(); ++i) {
    const auto& [x, y] = o[i];
    const auto& [u, v] = o[(i + 1) % o.size()];
    twice += x * v - y * u;
  }
  return twice / 2;
}

/// Triangles that all face the polygon's way, whose areas sum to that of the shoelace formula
/// (the independent reference), cover it once and nothing else.
void expect_covered(const FlatOutline& outline, const Quat& q, const Vec3& p,
                    double tolerance = 1e-12) {
  const PolygonSoup polygon = moved(one_polygon(outline), q, p);
  const Triangulated t = triangulate(polygon);
  const Vec3 normal = q * Vec3::UnitZ();
  double area = 0;
  for (const Triangle& k : t.soup.triangles) {
    const auto& x = t.soup.vertices;
    const double a = (x[k[1]] - x[k[0]]).cross(x[k[2]] - x[k[0]]).dot(normal) / 2;
    EXPECT_GT(a, 0);
    area += a;
  }
  EXPECT_NEAR(area, area_by_shoelace(outline), tolerance * area_by_shoelace(outline));
  EXPECT_EQ(t.soup.triangles.size() + t.degenerate, outline.size() - 2);
}

const FlatOutline arrow{{0, 0}, {2, 1}, {0, 2}, {0.5, 1}};
const FlatOutline letter_u{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
/// A square ring, its hole joined to the rim by a bridge that is walked both ways.
const FlatOutline keyhole{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                          {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};

FlatOutline comb_of_teeth(int teeth) {
  FlatOutline out{{0, -1}, {2.0 * teeth, -1}};
  for (int i = teeth; i-- > 0;) {
    out.push_back({2 * i + 2, 0});
    out.push_back({2 * i + 1.5, 5});
    out.push_back({2 * i + 1, 5});
    out.push_back({2 * i + 0.5, 0});
  }
  return out;
}

FlatOutline random_star(std::mt19937_64& random, int corners) {
  FlatOutline out;
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * std::numbers::pi * i / corners, r = test::uniform(random, 0.1, 1);
    out.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return out;
}

TEST(Triangulate, concave_polygons_keep_their_shape) {
  for (const FlatOutline& outline : {arrow, letter_u, keyhole, comb_of_teeth(20)})
    expect_covered(outline, Quat::Identity(), Vec3::Zero());
}

TEST(Triangulate, in_any_plane) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    const Quat q = test::random_rotation(random);
    const Vec3 p = test::random_in_ball(random, 5);
    for (const FlatOutline& outline : {arrow, letter_u, keyhole, random_star(random, 5 + i)})
      expect_covered(outline, q, p, 1e-11);
  }
}

TEST(Triangulate, each_concave_quad_wherever_it_starts) {
  FlatOutline quad = arrow;
  for (int i = 0; i < 4; ++i) {
    std::rotate(quad.begin(), quad.begin() + 1, quad.end());
    expect_covered(quad, Quat::Identity(), Vec3::Zero());
  }
}

TEST(Triangulate, convex_quads_are_cut_along_the_shorter_diagonal) {
  const auto t = triangulate(one_polygon({{0, 0}, {3, -1}, {6, 0}, {3, 1}})).soup.triangles;
  ASSERT_EQ(t.size(), 2u);
  EXPECT_EQ(t[0], (Triangle{0, 1, 3}));
  EXPECT_EQ(t[1], (Triangle{1, 2, 3}));
}

TEST(Triangulate, collinear_corners_cause_no_slivers) {
  const FlatOutline square{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  expect_covered(square, Quat::Identity(), Vec3::Zero());
  EXPECT_EQ(triangulate(one_polygon(square)).degenerate, 0u);
}

// A corner on the edge of one face only (a T-junction in the making) must stay in the topology.
TEST(Triangulate, closed_mesh_with_collinear_corners_stays_closed) {
  PolygonSoup box = test::box({2, 2, 2});
  box.points.push_back({0, -1, -1});  // the middle of the edge from 0 to 1
  for (auto& polygon : box.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (a + b == 1) {
        polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1, 8);
        break;
      }
    }
  const Soup all = triangulate_all(box);
  EXPECT_EQ(all.triangles.size(), 14u);
  EXPECT_TRUE(analyse_topology(all).closed);
}

TEST(Triangulate, polygons_without_area_are_set_aside) {
  const PolygonSoup line = one_polygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}});
  EXPECT_EQ(triangulate(line).degenerate, 3u);
  EXPECT_TRUE(triangulate(line).soup.triangles.empty());
  PolygonSoup repeats = one_polygon({{0, 0}, {1, 0}, {0, 1}});
  repeats.polygons = {{0, 1, 1, 2, 2}, {0, 1, 0}, {0, 1}, {1}};
  EXPECT_EQ(triangulate(repeats).soup.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(triangulate(repeats).degenerate, 3u);
}

TEST(Triangulate, crossing_and_warped_polygons_end_in_time) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200; ++i) {
    PolygonSoup wild;
    wild.polygons.emplace_back();
    for (std::size_t k = 0; k < 12; ++k) {
      wild.points.push_back(test::random_in_ball(random, 1));
      wild.polygons[0].push_back(k);
    }
    EXPECT_EQ(triangulate_all(wild).triangles.size(), 10u);
  }
}

TEST(Triangulate, large_convex_polygon_is_not_a_fan) {
  FlatOutline circle;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    circle.push_back({std::cos(a), std::sin(a)});
  }
  const Soup soup = triangulate_all(one_polygon(circle));
  std::vector<int> uses(soup.vertices.size(), 0);
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) ++uses[v];
  EXPECT_EQ(soup.triangles.size(), n - 2u);
  EXPECT_LE(*std::ranges::max_element(uses), 64);
}

TEST(IsDegenerate, tells_needles_from_lines) {
  for (const double s : {1e-150, 1e-9, 1.0, 1e150}) {  // at any scale
    const Vec3 a(0, 0, 0), b(s, 0, 0);
    EXPECT_FALSE(is_degenerate(a, b, Vec3(s / 2, s * 1e-8, 0)));
    EXPECT_FALSE(is_degenerate(a, b, Vec3(s / 2, s * 1e-14, 0)));
    EXPECT_TRUE(is_degenerate(a, b, Vec3(s / 2, s * 1e-16, 0)));
    EXPECT_TRUE(is_degenerate(a, b, Vec3(s / 2, 0, 0)));
    EXPECT_TRUE(is_degenerate(a, b, b));
    EXPECT_TRUE(is_degenerate(b, b, b));
  }
  EXPECT_TRUE(is_degenerate(Vec3(0, 0, 0), Vec3(1, 1, 1) / 3, Vec3(1, 1, 1)));
}

// A tangle has no right triangulation; it must be over in time (a minute would end the test), with
// each corner in a triangle.
TEST(Triangulate, a_tangle_of_many_corners_keeps_them_all) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  FlatOutline outline(50'000);
  for (auto& [x, y] : outline) x = anywhere(random), y = anywhere(random);
  const Soup soup = triangulate_all(one_polygon(outline));
  EXPECT_EQ(soup.triangles.size(), outline.size() - 2);
  std::vector<char> used(outline.size());
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t i : t) used[i] = 1;
  EXPECT_EQ(std::ranges::count(used, 1), std::ssize(outline));
}

}  // namespace
}  // namespace sonde
