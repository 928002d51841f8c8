// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde::test {

using Vec2 = Eigen::Vector2d;
/// A polygon in the plane, corners against the clock.
using Outline = std::vector<Vec2>;

inline Outline regular(int sides, double radius) {
  Outline out;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * std::numbers::pi * (i + 0.5) / sides;
    out.emplace_back(radius * std::cos(a), radius * std::sin(a));
  }
  return out;
}

inline Outline rectangle(double x, double y) {
  return {{-x / 2, -y / 2}, {x / 2, -y / 2}, {x / 2, y / 2}, {-x / 2, y / 2}};
}

/// A dovetail: wider above by the slope of its sides, at this angle to its base.
inline Outline dovetail(double base, double height, double angle) {
  const double more = height / std::tan(angle);
  return {{-base / 2, -height / 2},
          {base / 2, -height / 2},
          {base / 2 + more, height / 2},
          {-base / 2 - more, height / 2}};
}

/// A rectangle with corners rounded by arcs of some chords.
inline Outline rounded(double x, double y, double radius, int chords) {
  Outline out;
  for (int corner = 0; corner < 4; ++corner)
    for (int i = 0; i <= chords; ++i) {
      const double a = std::numbers::pi / 2 * (corner - 2 + double(i) / chords);
      const Vec2 centre((corner == 1 || corner == 2 ? 1 : -1) * (x / 2 - radius),
                        (corner >= 2 ? 1 : -1) * (y / 2 - radius));
      out.emplace_back(centre + radius * Vec2(std::cos(a), std::sin(a)));
    }
  return out;
}

/// The outline with each side moved outwards by `by`: corners where neighbouring lines meet.
inline Outline moved(const Outline& outline, double by) {
  Outline out;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto side = [&](std::size_t k) {
      const Vec2 along = outline[(k + 1) % n] - outline[k % n];
      const Vec2 normal = Vec2(along.y(), -along.x()).normalized();
      return std::pair(normal, normal.dot(outline[k % n]) + by);
    };
    const auto [a, at_a] = side(i + n - 1);
    const auto [b, at_b] = side(i);
    Eigen::Matrix2d rows;
    rows << a.transpose(), b.transpose();
    out.emplace_back(rows.inverse() * Vec2(at_a, at_b));
  }
  return out;
}

inline double area(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

/// From −height/2 to height/2 along z.
inline PolygonSoup prism(const Outline& outline, double height) {
  PolygonSoup out;
  const std::size_t n = outline.size();
  Polygon low, high;
  for (const double z : {-height / 2, height / 2})
    for (const Vec2& x : outline) out.points.emplace_back(x.x(), x.y(), z);
  for (std::size_t i = 0; i < n; ++i) {
    low.push_back(n - 1 - i);
    high.push_back(n + i);
    out.polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  out.polygons.push_back(low);
  out.polygons.push_back(high);
  return out;
}

/// A block of that height with a hole of that (convex) outline through it, 2.5 times as wide.
inline PolygonSoup block_with_hole(const Outline& hole, double height) {
  PolygonSoup out;
  const std::size_t n = hole.size();
  for (const double wide : {1.0, 2.5})
    for (const double z : {-height / 2, height / 2})
      for (const Vec2& x : hole) out.points.emplace_back(wide * x.x(), wide * x.y(), z);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    out.polygons.push_back({j, i, n + i, n + j});                          // the hole
    out.polygons.push_back({2 * n + i, 2 * n + j, 3 * n + j, 3 * n + i});  // outside
    out.polygons.push_back({n + i, 3 * n + i, 3 * n + j, n + j});          // above
    out.polygons.push_back({i, j, 2 * n + j, 2 * n + i});                  // below
  }
  return out;
}

/// Outlines of pegs, each exactly as large as its hole.
inline const std::vector<Outline>& pegs() {
  constexpr double mm = 1e-3;
  static const std::vector<Outline> all{rectangle(20 * mm, 20 * mm),
                                        rectangle(7 * mm, 31 * mm),
                                        regular(6, 10 * mm),
                                        regular(3, 25 * mm),
                                        regular(64, 10 * mm),
                                        regular(200, 4 * mm),
                                        dovetail(20 * mm, 10 * mm, 1.0472),
                                        dovetail(12 * mm, 5 * mm, 0.785),
                                        dovetail(8 * mm, 6 * mm, 1.2)};
  return all;
}

/// Another soup put beside one.
inline PolygonSoup together(PolygonSoup a, const PolygonSoup& b, const Vec3& by = Vec3::Zero()) {
  const std::size_t first = a.points.size();
  for (const Vec3& x : b.points) a.points.push_back(x + by);
  for (Polygon polygon : b.polygons) {
    for (std::size_t& corner : polygon) corner += first;
    a.polygons.push_back(polygon);
  }
  return a;
}

inline PolygonSoup inside_out(PolygonSoup soup) {
  for (Polygon& polygon : soup.polygons) std::ranges::reverse(polygon);
  return soup;
}

}  // namespace sonde::test
