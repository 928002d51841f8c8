// SPDX-License-Identifier: GPL-3.0-or-later
// Facets whose outlines touch, cross or cover themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/engine/body/facets_checks.hpp"

namespace sonde::test {
namespace {

/// Cells of a grid in the plane z = 0, where `is_there`.
template <class IsThere>
PolygonSoup cells(int n, const IsThere& is_there) {
  PolygonSoup out;
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * (n + 1) + x); };
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) out.points.emplace_back(x, y, 0);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      if (is_there(x, y))
        out.polygons.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
  return out;
}

// Closed form: the number of cells.
TEST(Facets, faces_that_touch_at_a_vertex_keep_their_shape) {
  const auto check = [](int n, const auto& is_there, std::size_t most) {
    const Soup soup = sewn(cells(n, is_there));
    const Facets facets = merged(soup, false);
    EXPECT_LE(facets.soup.triangles.size(), most);
    EXPECT_NEAR(area(facets.soup), static_cast<double>(soup.triangles.size()) / 2, 1e-12);
    check_same_surface(soup, facets, std::to_string(n));
  };
  // Two squares with a corner in common.
  check(
      6, [](int x, int y) { return (x < 3) == (y < 3); }, 4);
  // A hole that touches the outline at a corner; two holes that touch each other.
  check(
      6, [](int x, int y) { return !(x < 2 && y < 2) && !(x / 2 == 1 && y / 2 == 1); }, 10);
  check(
      8, [](int x, int y) { return (x / 2 != 1 || y / 2 != 1) && (x / 2 != 2 || y / 2 != 2); }, 18);
  // A chequerboard: nothing to gain, nothing lost.
  check(
      8, [](int x, int y) { return (x + y) % 2 == 0; }, 64);
}

TEST(Facets, random_holes_keep_their_shape) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 60; ++i) {
    const double share = test::uniform(random, 0.2, 0.95);
    const PolygonSoup flat =
        cells(9, [&](int, int) { return test::uniform(random, 0, 1) < share; });
    const Soup soup = sewn(i % 2 ? flat : test::turned(flat, some_turn()));
    const Facets facets = merged(soup, false);
    EXPECT_LE(facets.soup.triangles.size(), soup.triangles.size());
    check_same_surface(soup, facets, std::to_string(i));
  }
}

/// A ribbon about the z axis in the plane z = 0: what goes further round than once lies over
/// itself.
PolygonSoup spiral(double turns) {
  PolygonSoup out;
  constexpr std::size_t across = 5;
  const auto n = static_cast<std::size_t>(turns * 24);
  for (std::size_t i = 0; i <= n; ++i) {
    const double a = 2 * std::numbers::pi * static_cast<double>(i) / 24;
    for (std::size_t k = 0; k < across; ++k)
      out.points.push_back((1 + 0.25 * static_cast<double>(k) + 0.01 * a) *
                           Vec3(std::cos(a), std::sin(a), 0));
  }
  for (std::size_t at = 0; at < n * across; ++at)
    if (at % across + 1 < across)
      out.polygons.push_back({at, at + 1, at + 1 + across, at + across});
  return out;
}

TEST(Facets, what_folds_over_itself_stays_as_it_is) {
  for (const double turns : {1.25, 1.5, 2.25}) {
    const Soup soup = sewn(spiral(turns));
    const Facets facets = merged(soup, false);
    EXPECT_EQ(facets.merged, 0u) << turns;
    EXPECT_EQ(triangle_set(facets.soup), triangle_set(soup)) << turns;
  }
  // Less than once round it does not.
  EXPECT_GT(merged(sewn(spiral(0.75)), false).merged, 0u);
}

/// A large square and a small one over its middle, both cut from p to q and sewn to each other
/// there crosswise: one sheet, that lies twice on the small square. Its outline is two squares.
PolygonSoup two_leaves(double small) {
  PolygonSoup out;
  const auto vertex = [&](double x, double y) {
    out.points.emplace_back(x, y, 0);
    return out.points.size() - 1;
  };
  const double slit = small / 2;
  const std::size_t p = vertex(-slit, 0), q = vertex(slit, 0);
  // Banks of the slit: the upper one of a leaf is the lower one of the other.
  const std::size_t bank[2] = {vertex(0, 0.1 * small), vertex(0, -0.1 * small)};
  for (int leaf = 0; leaf < 2; ++leaf) {
    const double h = leaf ? small : 1;
    const std::size_t e = vertex(h, 0), n = vertex(0, h), w = vertex(-h, 0), s = vertex(0, -h);
    const std::size_t ne = vertex(h, h), nw = vertex(-h, h), sw = vertex(-h, -h),
                      se = vertex(h, -h);
    const std::size_t up = bank[leaf], down = bank[1 - leaf];
    for (const auto& t : {std::array{q, e, ne},
                          {q, ne, n},
                          {q, n, up},
                          {up, n, p},
                          {p, n, nw},
                          {p, nw, w},
                          {p, w, sw},
                          {p, sw, s},
                          {p, s, down},
                          {down, s, q},
                          {q, s, se},
                          {q, se, e}})
      out.polygons.push_back({t[0], t[1], t[2]});
  }
  return out;
}

// The outline of such a sheet does not cross itself, and tells of a hole where the sheet lies
// twice. However small that is beside the whole, there must be none.
TEST(Facets, what_lies_twice_on_itself_gets_no_hole) {
  for (const double small : {0.5, 1e-2, 1e-4, 1e-5}) {
    const Soup soup = sewn(two_leaves(small));
    const Facets facets = merged(soup, false);
    const Vec3 inside(0.3 * small, 0.4 * small, 0);
    EXPECT_LE(distance(facets.soup, inside), rounding_flatness(soup)) << small;
  }
}

TEST(Facets, a_face_is_not_joined_with_its_own_back_side) {
  // A square sheet with another one, turned over, that hangs on one of its sides.
  PolygonSoup sheet = cells(4, [](int, int) { return true; });
  PolygonSoup back = test::turned_over(sheet);
  for (Vec3& x : back.points)
    if (x.y() > 0) x.x() += 1e-3 * x.y();  // one side in common
  const Soup soup = sewn(joined(sheet, back));
  const Facets facets = merged(soup, false);
  EXPECT_EQ(facets.soup.triangles.size(), 4u);
  check_same_surface(soup, facets, "sheet");
}

}  // namespace
}  // namespace sonde::test
