// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/geometry/body.hpp"
#include "engine/proximity/triangle_pair.hpp"

namespace sonde {

/// Largest absolute coordinate of a body in its mesh frame, m.
double extent(const Body& body);

inline Corners corners(const Soup& soup, std::uint32_t triangle) {
  const Triangle& t = soup.triangles[triangle];
  return {soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]};
}

inline Corners place(const Transform& X, const Corners& c) {
  return {X * c[0], X * c[1], X * c[2]};
}

inline Vec3 center(const Tree::Node& n) { return {n.center[0], n.center[1], n.center[2]}; }
inline Vec3 half_size(const Tree::Node& n) { return {n.half[0], n.half[1], n.half[2]}; }

/// The rounding error allowed for in coordinates of A placed at X in B's frame, m: well above what
/// a rotation, a translation and a projection of such numbers can lose.
inline double rounding_guard(double extent_a, double extent_b, const Vec3& translation) {
  return 64 * std::numeric_limits<double>::epsilon() *
         (extent_a + extent_b + translation.cwiseAbs().maxCoeff());
}

/// Four floats at once; the fourth lane idles.
typedef float Float4 __attribute__((vector_size(16)));

/// Body A placed in B's mesh frame by X_BA: what every query on the pair walks the two trees with.
/// Boxes are compared in single precision, four numbers at a time, with its rounding error taken
/// off the distance.
class Placement {
 public:
  Placement(const Body& a, const Body& b, const Transform& X_BA);

  Corners corners_a(std::uint32_t triangle) const { return place(X, corners(a_->soup, triangle)); }
  Corners corners_b(std::uint32_t triangle) const { return corners(b_->soup, triangle); }

  /// The axis of least overlap of two boxes among their six face normals.
  struct BoxGap {
    double gap;  ///< a lower bound of the separation along the axis (negative: they overlap on all
                 ///< six), m
    Vec3 axis;   ///< unit, in B's frame, from box B to box A
  };
  static BoxGap box_gap_at(const Transform& X, double guard, const Tree::Node& na,
                           const Tree::Node& nb);

  /// A lower bound of the distance of two boxes, m; negative or 0: they may overlap.
  double box_distance(const Tree::Node& na, const Tree::Node& nb) const {
    const Outside out = outside(na, nb);
    return std::sqrt(std::max(sum_of_squares(out.in_a), sum_of_squares(out.in_b))) - float_guard_;
  }
  /// box_gap's gap alone, to order by and to see overlap.
  double box_overlap(const Tree::Node& na, const Tree::Node& nb) const {
    const Outside out = outside(na, nb);
    const Float4 m = out.in_a > out.in_b ? out.in_a : out.in_b;
    return std::max({m[0], m[1], m[2]}) - float_guard_;
  }

  Transform X;
  double guard;  ///< see rounding_guard

 private:
  /// By how much the boxes are apart along the axes of either (negative: they overlap there).
  struct Outside {
    Float4 in_a, in_b;
  };
  static Float4 load(const float* p) {
    Float4 f;
    __builtin_memcpy(&f, p, sizeof f);
    return f;
  }
  static Float4 all(float x) { return Float4{x, x, x, x}; }
  static Float4 magnitude(Float4 x) { return x < 0 ? -x : x; }
  static double sum_of_squares(Float4 x) {
    const Float4 zero{};
    const Float4 p = x > zero ? x : zero;
    const Float4 q = p * p;
    return static_cast<double>(q[0] + q[1] + q[2]);
  }
  Outside outside(const Tree::Node& na, const Tree::Node& nb) const {
    const Float4 hb{nb.half[0], nb.half[1], nb.half[2], 0};
    const Float4 ha{na.half[0], na.half[1], na.half[2], 0};
    const Float4 d = columns_[0] * all(na.center[0]) + columns_[1] * all(na.center[1]) +
                     columns_[2] * all(na.center[2]) + shift_ - load(nb.center);
    const Float4 reach_a = abs_columns_[0] * all(na.half[0]) + abs_columns_[1] * all(na.half[1]) +
                           abs_columns_[2] * all(na.half[2]);
    const Float4 d_a = rows_[0] * all(d[0]) + rows_[1] * all(d[1]) + rows_[2] * all(d[2]);
    const Float4 reach_b = abs_rows_[0] * all(nb.half[0]) + abs_rows_[1] * all(nb.half[1]) +
                           abs_rows_[2] * all(nb.half[2]);
    return {magnitude(d_a) - ha - reach_b, magnitude(d) - hb - reach_a};
  }

  const Body* a_;
  const Body* b_;
  Float4 columns_[3], abs_columns_[3], rows_[3], abs_rows_[3], shift_;
  float float_guard_;
};

/// Pairs of nodes still to be visited: a stack of fixed size, no allocation. A depth-first walk of
/// two trees of depth p and q that pushes two children for the one popped never holds more than p +
/// q + 1 entries, and trees are at most 60 deep.
template <class Entry>
class PairStack {
 public:
  bool empty() const { return size_ == 0; }
  void push(const Entry& e) { items_[size_++] = e; }
  Entry pop() { return items_[--size_]; }

 private:
  Entry items_[160];
  int size_ = 0;
};

/// Which of two nodes to open: the one with the larger box, a leaf never.
inline bool open_first(const Tree::Node& na, const Tree::Node& nb) {
  if (na.is_leaf()) return false;
  if (nb.is_leaf()) return true;
  return na.half[0] + na.half[1] + na.half[2] > nb.half[0] + nb.half[1] + nb.half[2];
}

}  // namespace sonde
