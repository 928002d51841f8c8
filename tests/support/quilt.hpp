// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <random>
#include <vector>

#include "tests/support/conforming.hpp"

namespace sonde::test {

/// Sews a closed mesh of flat patches that are cut finely. Neighbours that name the same two
/// corners and as many cuts between them get the same points on their common edge, to the bit.
class Quilt {
 public:
  explicit Quilt(const Cutting& cutting) : cutting_(cutting), random_(cutting.seed) {}

  /// A flat convex quadrilateral, anticlockwise from outside: nu cells from a to b, nv from b to c.
  void patch(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int nu, int nv);
  /// The triangle a, b, apex, where only the side from a to b is cut.
  void fan(const Vec3& a, const Vec3& b, const Vec3& apex, int n);

  PolygonSoup take() { return std::move(soup_); }

 private:
  std::vector<double> cuts(int n);
  std::vector<Vec3> edge(const Vec3& from, const Vec3& to, int n);
  void quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c);

  Cutting cutting_;
  std::mt19937_64 random_;
  /// Where an edge is cut, 0..1 from its lower end (in lexicographic order).
  std::map<std::array<double, 7>, std::vector<double>> edges_;
  PolygonSoup soup_;
};

}  // namespace sonde::test
