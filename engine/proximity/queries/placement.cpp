// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/placement.hpp"

#include <bit>

#include "engine/geometry/to_float.hpp"

namespace sonde {
namespace {

/// The longest side of the axis-aligned bounding box, m.
double local_extent(const Tree& tree) { return (tree.high - tree.low).maxCoeff(); }

}  // namespace

double extent(const Body& body) {
  return std::max(body.tree.low.cwiseAbs().maxCoeff(), body.tree.high.cwiseAbs().maxCoeff());
}

bool balls_are_apart(const Body& a, const Body& b, const Transform& X_BA) {
  const Vec3 between = X_BA * (0.5 * (a.tree.low + a.tree.high)) - 0.5 * (b.tree.low + b.tree.high);
  const double radii =
      0.5 * ((a.tree.high - a.tree.low).norm() + (b.tree.high - b.tree.low).norm());
  const double reach = radii + rounding_guard(extent(a), extent(b), X_BA.p);
  return between.squaredNorm() > reach * reach;
}

namespace {

FrameChange::Column column(const Vec3& x) {
  return FrameChange::Column{static_cast<float>(x.x()), static_cast<float>(x.y()),
                             static_cast<float>(x.z()), 0};
}

FrameChange change(const Mat3& R, const Vec3& from, const Vec3& p, const Vec3& to) {
  return {
      {column(R.col(0)), column(R.col(1)), column(R.col(2))}, column(from), column(p), column(to)};
}

FrameChange::Column turned(const FrameChange& change, const float (&rows)[3][Tree::width],
                           std::uint32_t k) {
  return change.R[0] * rows[0][k] + change.R[1] * rows[1][k] + change.R[2] * rows[2][k];
}

void copy(const FrameChange::Column& from, float (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

/// x rounded to single precision.
Vec3 rounded(const Vec3& x) {
  return {static_cast<double>(to_float(x.x())), static_cast<double>(to_float(x.y())),
          static_cast<double>(to_float(x.z()))};
}

}  // namespace

Frames frames(const Tree& a, const Tree& b, const Transform& X, double per_unit) {
  const Vec3 shift = (X * a.origin - b.origin) * per_unit;
  const Mat3 back = X.R.transpose();
  const bool about_a = local_extent(a) <= local_extent(b);
  const Vec3 in_b = about_a ? rounded(shift) : Vec3::Zero();
  const Vec3 in_a = about_a ? Vec3::Zero() : rounded(-(back * shift));
  // The distance that remains between the rounded middles.
  const Vec3 rest = shift + X.R * in_a - in_b;
  return {change(X.R, in_a, rest, in_b), change(back, in_b, -(back * rest), in_a), in_a / per_unit,
          in_b / per_unit};
}

double placing_guard(const Tree& a, const Tree& b) {
  return box_rounding * std::min(local_extent(a), local_extent(b));
}

PlacedBox placed(const Tree& tree, std::uint32_t slot, const FrameChange& change, float scale) {
  const Tree::Node& node = tree.nodes[slot / Tree::width];
  const std::uint32_t k = slot % Tree::width;
  PlacedBox box;
  const FrameChange::Column center =
      FrameChange::Column{node.center[0][k], node.center[1][k], node.center[2][k], 0} * scale -
      change.from;
  copy(change.R[0] * center[0] + change.R[1] * center[1] + change.R[2] * center[2] + change.p,
       box.center);
  copy(change.to, box.origin);
  copy(turned(change, node.axis[0], k), box.axis[0]);
  copy(turned(change, node.axis[1], k), box.axis[1]);
  const float(&u)[3] = box.axis[0];
  const float(&v)[3] = box.axis[1];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, l = (i + 2) % 3;
    box.axis[2][i] = u[j] * v[l] - u[l] * v[j];
    box.half[i] = scale * node.half[i][k];
  }
  return box;
}

Placement::Placement(const Body& a, const Body& b, const Transform& X_BA)
    : X(X_BA),
      guard(rounding_guard(extent(a), extent(b), X_BA.p)),
      a_(a),
      b_(b),
      kernels_(box_kernels()) {
  const Vec3 shift = X * a.tree.origin - b.tree.origin;
  const double size = local_extent(a.tree) + local_extent(b.tree) + shift.cwiseAbs().maxCoeff();
  per_unit_ = std::ldexp(1.0, -std::ilogb(size));
  scale_ = static_cast<float>(per_unit_);
  frames_ = frames(a.tree, b.tree, X, per_unit_);
  float_guard_ =
      static_cast<float>((placing_guard(a.tree, b.tree) + guard) * per_unit_) * (1 + 0x1p-22f) +
      underflow_guard;
}

void Placement::try_direction(const Vec3& from_b_to_a) {
  const Vec3 n = from_b_to_a.normalized();
  if (!n.allFinite()) return;
  toward_a_ = n.cast<float>();
  toward_b_ = -(X.R.transpose() * n).cast<float>();
}

std::uint32_t Placement::compare(std::uint32_t slot_a, const Tree::Node& node_b, Kernel kernel,
                                 float limit, Lanes& bounds) const {
  PlacedBox box = placed(a_.tree, slot_a, frames_.a_to_b, scale_);
  Eigen::Map<Eigen::Vector3f>(box.direction) = toward_a_;
  Eigen::Map<Eigen::Vector3f>(box.shift) = shift_of_a_;
  kernel(box, node_b, scale_, bounds);
  return at_most(bounds, limit + float_guard_, node_b);
}

std::uint32_t Placement::compare(const Tree::Node& node_a, std::uint32_t slot_b, Kernel kernel,
                                 float limit, Lanes& bounds) const {
  PlacedBox box = placed(b_.tree, slot_b, frames_.b_to_a, scale_);
  Eigen::Map<Eigen::Vector3f>(box.direction) = toward_b_;
  Eigen::Map<Eigen::Vector3f>(box.shift) = shift_of_b_;
  kernel(box, node_a, scale_, bounds);
  return at_most(bounds, limit + float_guard_, node_a);
}

void Placement::open_a(const SlotPair& p, std::uint32_t lanes, Kernel kernel, float limit,
                       SlotPairs& out) const {
  const std::uint32_t child = a_.tree.child(p.a);
  Lanes bounds;
  lanes &= compare(a_.tree.nodes[child], p.b, kernel, limit, bounds);
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto k = static_cast<std::uint32_t>(std::countr_zero(lanes));
    out.push(down_a(p, a_.tree, child, k, bounds.value[k] - float_guard_));
  }
}

void Placement::open_b(const SlotPair& p, std::uint32_t lanes, Kernel kernel, float limit,
                       SlotPairs& out) const {
  const std::uint32_t child = b_.tree.child(p.b);
  Lanes bounds;
  lanes &= compare(p.a, b_.tree.nodes[child], kernel, limit, bounds);
  for (; lanes != 0; lanes &= lanes - 1) {
    const auto k = static_cast<std::uint32_t>(std::countr_zero(lanes));
    out.push(down_b(p, b_.tree, child, k, bounds.value[k] - float_guard_));
  }
}

void Placement::open_larger(const SlotPair& p, Kernel kernel, float limit, SlotPairs& out) const {
  constexpr std::uint32_t all = 0xffff;
  out.count = 0;
  opens_a(a_.tree, b_.tree, p) ? open_a(p, all, kernel, limit, out)
                               : open_b(p, all, kernel, limit, out);
}

void Placement::open_both(const SlotPair& p, Kernel kernel, float limit, SlotPairs& out) const {
  const std::uint32_t child_a = a_.tree.child(p.a), child_b = b_.tree.child(p.b);
  if ((child_a | child_b) & Tree::triangle_bit) return open_larger(p, kernel, limit, out);
  out.count = 0;
  // Compares the children of each box with the other box first. That mostly leaves few children,
  // fewer still on one side; these are then compared with the remaining children of the other.
  Lanes bounds;
  const std::uint32_t near_b = compare(p.a, b_.tree.nodes[child_b], kernel, limit, bounds);
  if (near_b == 0) return;
  const std::uint32_t near_a = compare(a_.tree.nodes[child_a], p.b, kernel, limit, bounds);
  const bool by_a = std::popcount(near_a) <= std::popcount(near_b);
  for (std::uint32_t each = by_a ? near_a : near_b; each != 0; each &= each - 1) {
    const auto k = static_cast<std::uint32_t>(std::countr_zero(each));
    if (by_a)
      open_b(down_a(p, a_.tree, child_a, k, 0), near_b, kernel, limit, out);
    else
      open_a(down_b(p, b_.tree, child_b, k, 0), near_a, kernel, limit, out);
  }
}

void Placement::open_near(const SlotPair& p, float limit, SlotPairs& out) const {
  open_both(p, kernels_.distances, limit, out);
}

void Placement::open_by_faces(const SlotPair& p, float limit, SlotPairs& out) const {
  open_both(p, kernels_.gaps, limit, out);
}

void Placement::open_shifted(const SlotPair& p, const Vec3& shift, float limit, SlotPairs& out) {
  shift_of_a_ = (per_unit_ * shift).cast<float>();
  shift_of_b_ = -(per_unit_ * (X.R.transpose() * shift)).cast<float>();
  open_both(p, kernels_.gaps_shifted, limit, out);
}

void Placement::open_larger_box(const SlotPair& p, SlotPairs& out) const {
  open_larger(p, kernels_.distances, std::numeric_limits<float>::infinity(), out);
}

void Placement::open_overlapping(const SlotPair& p, Opening opening, SlotPairs& out) const {
  if (opening == Opening::larger)
    open_larger(p, kernels_.gaps, 0, out);
  else
    open_both(p, kernels_.gaps, 0, out);
}

}  // namespace sonde
