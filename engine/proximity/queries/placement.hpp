// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/boxes/box_lanes.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"
#include "engine/simd/vectors.hpp"

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

/// Bound of the rounding error of coordinates of A placed at X in B's frame, m: well above what a
/// rotation, a translation and a projection of such numbers can lose.
inline double rounding_guard(double extent_a, double extent_b, const Vec3& translation) {
  return 64 * std::numeric_limits<double>::epsilon() *
         (extent_a + extent_b + translation.cwiseAbs().maxCoeff());
}

/// Whether the bounding balls of both meshes' axis-aligned boxes are apart, with A placed at X in
/// B's frame; then no point of either body is in the other. The early exit of a query on bodies far
/// apart.
bool balls_are_apart(const Body& a, const Body& b, const Transform& X_BA);

/// Takes boxes of one tree to the frame of the other: x → R (x − from) + p, relative to the origin
/// `to`. All lengths are in a unit of which a metre has `per_unit`.
struct FrameChange {
  using Column = FloatX4;
  Column R[3];
  Column from, p, to;
};
/// A's boxes to B's frame and back, for A's mesh frame placed at X in B's. Both are relative to the
/// middle of the smaller body, so that a large body does not cause rounding errors of its own size.
struct Frames {
  FrameChange a_to_b, b_to_a;
  Vec3 middle_a = Vec3::Zero();  ///< m, relative to the tree's origin, in its frame
  Vec3 middle_b = Vec3::Zero();
};
Frames frames(const Tree& a, const Tree& b, const Transform& X, double per_unit);
/// Bound of the rounding error of placing a box, m: box_rounding × the size of the smaller body.
double placing_guard(const Tree& a, const Tree& b);

PlacedBox placed(const Tree& tree, std::uint32_t slot, const FrameChange& change, float scale);

/// A pair of boxes still to be examined.
struct SlotPair {
  std::uint32_t a, b;    ///< slots of the two trees
  float bound;           ///< lower bound for the pair, in the placement's unit
  float size_a, size_b;  ///< half the sum of the sides of either box, m
};
inline SlotPair roots(const Tree& a, const Tree& b) {
  return {0, 0, 0, a.half_sum(0), b.half_sum(0)};
}
/// The pair with its box of A (or of B) replaced by a lane of the node below it.
inline SlotPair down_a(const SlotPair& p, const Tree& a, std::uint32_t node, std::uint32_t lane,
                       float bound) {
  return {node * Tree::width + lane, p.b, bound, a.nodes[node].half_sum(lane), p.size_b};
}
inline SlotPair down_b(const SlotPair& p, const Tree& b, std::uint32_t node, std::uint32_t lane,
                       float bound) {
  return {p.a, node * Tree::width + lane, bound, p.size_a, b.nodes[node].half_sum(lane)};
}

/// Work, in units of Effort, to open a pair of boxes that yields `found` pairs.
constexpr int work_to_open(int found) { return 12 + 4 * found; }

/// True if both slots hold triangles.
inline bool is_leaf(const Tree& a, const Tree& b, const SlotPair& p) {
  return (a.child(p.a) & b.child(p.b) & Tree::triangle_bit) != 0;
}
/// True if the slot of A is to be opened, false if that of B is: the one with the larger box. At
/// least one of the two must not hold a triangle.
inline bool opens_a(const Tree& a, const Tree& b, const SlotPair& p) {
  if (b.child(p.b) & Tree::triangle_bit) return true;
  return (a.child(p.a) & Tree::triangle_bit) == 0 && p.size_a > p.size_b;
}

/// The pairs of boxes or triangles that opening one pair yields.
struct SlotPairs {
  std::array<SlotPair, Tree::width * Tree::width> pair;
  int count = 0;
  SlotPair* begin() { return pair.data(); }
  SlotPair* end() { return pair.data() + count; }
  void push(const SlotPair& p) { pair[static_cast<std::size_t>(count++)] = p; }
};

/// Whether a pair is opened by its larger box alone or by both boxes at once. The first is quicker
/// for a query that ends at the first overlap.
enum class Opening { larger, both };

/// Body A placed in B's mesh frame by X_BA. Every query on the pair traverses the two trees with
/// it. It compares boxes in single precision, in a unit in which all are of the order of 1, and
/// subtracts the rounding error from each distance.
class Placement {
 public:
  Placement(const Body& a, const Body& b, const Transform& X_BA);

  Corners corners_a(std::uint32_t triangle) const {
    return place(X, corners(surface(a_), triangle));
  }
  Corners corners_b(std::uint32_t triangle) const { return corners(surface(b_), triangle); }

  /// Converts a length from m to the placement's unit, rounded up. An infinite length stays
  /// infinite.
  float to_unit_rounded_up(double length) const {
    return static_cast<float>(length * per_unit_) * (1 + 0x1p-22f);
  }

  /// Converts a bound from the placement's unit to m, and rounds it down.
  double to_metres_rounded_down(float bound) const {
    return static_cast<double>(bound) / per_unit_ * (1 - 1e-7);
  }

  bool is_leaf(const SlotPair& p) const { return sonde::is_leaf(a_.tree, b_.tree, p); }
  std::uint32_t triangle_a(const SlotPair& p) const {
    return a_.tree.child(p.a) & ~Tree::triangle_bit;
  }
  std::uint32_t triangle_b(const SlotPair& p) const {
    return b_.tree.child(p.b) & ~Tree::triangle_bit;
  }

  SlotPair roots() const { return sonde::roots(a_.tree, b_.tree); }
  /// Opens both boxes of a pair that is not a leaf, and writes the pairs of their contents to `out`
  /// with a lower bound of the distance of each. The bound of boxes that overlap is negative: the
  /// deeper, the lower. Pairs with a bound above `limit` are left out. Bounds and `limit` are in
  /// the placement's unit.
  void open_near(const SlotPair& p, float limit, SlotPairs& out) const;
  /// As open_near, but the bound is the largest separation along the six face normals. It takes
  /// less work, and is lower for boxes whose nearest points are corners or edges.
  void open_by_faces(const SlotPair& p, float limit, SlotPairs& out) const;
  /// As open_by_faces, but the bound holds along a straight motion of A's box from here: `shift`
  /// is its displacement, m, in B's frame.
  void open_shifted(const SlotPair& p, const Vec3& shift, float limit, SlotPairs& out);
  /// Opens the larger box only, without a limit. A query uses it for its first descent.
  void open_larger_box(const SlotPair& p, SlotPairs& out) const;
  /// Opens one box or both, and leaves out the pairs that one of the six face normals separates.
  void open_overlapping(const SlotPair& p, Opening opening, SlotPairs& out) const;

  /// Sets a direction (from B to A, in B's frame) along which open_near also compares boxes. The
  /// direction of the nearest points so far is likely to separate boxes well.
  void try_direction(const Vec3& from_b_to_a);

  Transform X;
  double guard;  ///< see rounding_guard

 private:
  using Kernel = void (*)(const PlacedBox&, const Tree::Node&, float, Lanes&);
  /// Compares the sixteen boxes of a node with one box of the other tree. Returns a bit for each
  /// one within the limit.
  std::uint32_t compare(std::uint32_t slot_a, const Tree::Node& node_b, Kernel kernel, float limit,
                        Lanes& bounds) const;
  std::uint32_t compare(const Tree::Node& node_a, std::uint32_t slot_b, Kernel kernel, float limit,
                        Lanes& bounds) const;
  void open_a(const SlotPair& p, std::uint32_t lanes, Kernel kernel, float limit,
              SlotPairs& out) const;
  void open_b(const SlotPair& p, std::uint32_t lanes, Kernel kernel, float limit,
              SlotPairs& out) const;
  void open_larger(const SlotPair& p, Kernel kernel, float limit, SlotPairs& out) const;
  void open_both(const SlotPair& p, Kernel kernel, float limit, SlotPairs& out) const;

  const Body& a_;
  const Body& b_;
  const BoxKernels& kernels_;
  Frames frames_;
  Eigen::Vector3f toward_a_ = Eigen::Vector3f::Zero();  // in B's frame
  Eigen::Vector3f toward_b_ = Eigen::Vector3f::Zero();  // in A's frame
  // Displacement of A's box in B's frame, and of B's box in A's frame, in the placement's unit.
  Eigen::Vector3f shift_of_a_ = Eigen::Vector3f::Zero();
  Eigen::Vector3f shift_of_b_ = Eigen::Vector3f::Zero();
  double per_unit_;
  float scale_;
  float float_guard_;
};

/// A stack of the pairs that a query has still to visit. Its size is fixed and nothing allocates.
/// Opening both boxes of a pair removes one entry and adds up to 256; in one descent this happens
/// at most max_depth times. Opening one box adds up to 16, at most twice as often.
template <class Entry>
class PairStack {
 public:
  bool empty() const { return size_ == 0; }
  void clear() { size_ = 0; }
  void push(const Entry& e) { items_[size_++] = e; }
  Entry pop() { return items_[--size_]; }

 private:
  Entry items_[Tree::max_depth * (Tree::width + 2) * Tree::width];
  int size_ = 0;
};

}  // namespace sonde
