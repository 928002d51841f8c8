// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of facets have in common: the checks that a merged surface is the same as before.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include "engine/body/body.hpp"
#include "engine/body/facets.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "tests/support/conforming.hpp"
#include "tests/support/defects.hpp"

namespace sonde::test {

inline Soup sewn(const PolygonSoup& polygons) { return compacted(triangulate(polygons).soup); }

inline Facets merged(const Soup& soup, bool solid = true) {
  return merge_flat(soup, rounding_flatness(soup), solid);
}

inline double area(const Soup& soup) { return mass_by_area(soup).measure; }
inline double volume(const Soup& soup) { return mass_by_volume(soup).measure; }

inline double size_of(const Soup& soup) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : soup.vertices) box.extend(x);
  return box.sizes().maxCoeff();
}

/// Distance to the nearest triangle, by closest_points on all of them.
inline double distance(const Soup& soup, const Vec3& x) {
  double least = 1e300;
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i)
    least = std::min(least, closest_points({x, x, x}, corners(soup, i), least).distance);
  return least;
}

/// How far a soup leaves another: at its corners, and at points of it.
inline double strays(const Soup& soup, const Soup& from, std::mt19937_64& random) {
  double most = 0;
  const std::size_t step = soup.triangles.size() / 60 + 1;
  for (std::uint32_t i = 0; i < soup.triangles.size(); i += static_cast<std::uint32_t>(step)) {
    const Corners t = corners(soup, i);
    for (const Vec3& x : t) most = std::max(most, distance(from, x));
    for (int k = 0; k < (step > 1 ? 2 : 8); ++k) {
      double u = test::uniform(random, 0, 1), v = test::uniform(random, 0, 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      most = std::max(most, distance(from, t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0])));
    }
  }
  return most;
}

/// Reference: the soup itself. The same points both ways, the same area, and for what is closed the
/// same volume; `from` names a triangle that hangs together with each; vertices are the soup's.
inline void check_same_surface(const Soup& soup, const Facets& facets, const std::string& what) {
  std::mt19937_64 random(5);
  const double rounding = 2 * rounding_flatness(soup) + 1e-15 * size_of(soup);
  EXPECT_LE(strays(soup, facets.soup, random), rounding) << what;
  EXPECT_LE(strays(facets.soup, soup, random), rounding) << what;
  EXPECT_EQ(facets.soup.vertices, soup.vertices) << what;
  ASSERT_EQ(facets.from.size(), facets.soup.triangles.size()) << what;
  const Components components = find_components(soup);
  std::vector<std::uint32_t> of_vertex(soup.vertices.size());
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    for (const std::uint32_t v : soup.triangles[i]) of_vertex[v] = components.of[i];
  for (std::size_t i = 0; i < facets.from.size(); ++i)
    for (const std::uint32_t v : facets.soup.triangles[i])
      EXPECT_EQ(of_vertex[v], components.of[facets.from[i]]) << what;
  if (facets.duplicates > 0) return;
  const double whole = area(soup);
  EXPECT_NEAR(area(facets.soup), whole, 1e-9 * whole) << what;
  EXPECT_NEAR(volume(facets.soup), volume(soup), 1e-9 * whole * size_of(soup)) << what;
}

inline const char* name(Cutting::Kind kind) {
  switch (kind) {
    case Cutting::Kind::regular:
      return "regular";
    case Cutting::Kind::random:
      return "random";
    default:
      return "slivers";
  }
}
inline constexpr Cutting::Kind kinds[] = {Cutting::Kind::regular, Cutting::Kind::random,
                                          Cutting::Kind::slivers};

inline Quat some_turn() { return Quat(0.8, 0.3, -0.4, 0.35).normalized(); }

inline PolygonSoup moved(PolygonSoup soup, const Vec3& by) {
  for (Vec3& x : soup.points) x += by;
  return soup;
}
/// Triangles however their corners are numbered, as often as they are there.
inline std::multiset<Triangle> triangle_set(const Soup& soup) {
  std::multiset<Triangle> out;
  for (Triangle t : soup.triangles) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    out.insert(t);
  }
  return out;
}

}  // namespace sonde::test
