// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/placement.hpp"

#include <bit>

namespace sonde {
namespace {

/// The largest distance of a corner from the tree's origin along an axis, m.
double local_extent(const Tree& tree) { return (tree.high - tree.low).maxCoeff(); }

}  // namespace

double extent(const Body& body) {
  return std::max(body.tree.low.cwiseAbs().maxCoeff(), body.tree.high.cwiseAbs().maxCoeff());
}

namespace {

FrameChange::Column column(const Vec3& x) {
  return FrameChange::Column{static_cast<float>(x.x()), static_cast<float>(x.y()),
                             static_cast<float>(x.z()), 0};
}

FrameChange change(const Mat3& R, const Vec3& p) {
  return {{column(R.col(0)), column(R.col(1)), column(R.col(2))}, column(p)};
}

FrameChange::Column turned(const FrameChange& change, const float (&rows)[3][Tree::width],
                           std::uint32_t k) {
  return change.R[0] * rows[0][k] + change.R[1] * rows[1][k] + change.R[2] * rows[2][k];
}

void copy(const FrameChange::Column& from, float (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace

FrameChange a_to_b(const Tree& a, const Tree& b, const Transform& X, double per_unit) {
  return change(X.R, (X * a.origin - b.origin) * per_unit);
}

FrameChange b_to_a(const Tree& a, const Tree& b, const Transform& X, double per_unit) {
  const Mat3 back = X.R.transpose();
  return change(back, back * (b.origin - X * a.origin) * per_unit);
}

PlacedBox placed(const Tree& tree, std::uint32_t slot, const FrameChange& change, float scale) {
  const Tree::Node& node = tree.nodes[slot / Tree::width];
  const std::uint32_t k = slot % Tree::width;
  PlacedBox box;
  copy(turned(change, node.center, k) * scale + change.p, box.center);
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
  // Between the trees' origins, so that what is far from the meshes' own origins loses nothing.
  const Vec3 shift = X * a.tree.origin - b.tree.origin;
  const double size = local_extent(a.tree) + local_extent(b.tree) + shift.cwiseAbs().maxCoeff();
  per_unit_ = std::exp2(-std::ilogb(size));
  scale_ = static_cast<float>(per_unit_);
  a_to_b_ = a_to_b(a.tree, b.tree, X, per_unit_);
  b_to_a_ = b_to_a(a.tree, b.tree, X, per_unit_);
  float_guard_ = static_cast<float>((box_rounding * size + guard) * per_unit_) * (1 + 0x1p-22f);
}

void Placement::try_direction(const Vec3& from_b_to_a) {
  const Vec3 n = from_b_to_a.normalized();
  if (!n.allFinite()) return;
  toward_a_ = n.cast<float>();
  toward_b_ = -(X.R.transpose() * n).cast<float>();
}

void Placement::open(const SlotPair& p, Kernel kernel, float limit, SlotPairs& out) const {
  const std::uint32_t child_a = a_.tree.child(p.a), child_b = b_.tree.child(p.b);
  const bool open_a = opens_a(a_.tree, b_.tree, p);
  const Tree::Node& node = open_a ? a_.tree.nodes[child_a] : b_.tree.nodes[child_b];
  PlacedBox other =
      open_a ? placed(b_.tree, p.b, b_to_a_, scale_) : placed(a_.tree, p.a, a_to_b_, scale_);
  Eigen::Map<Eigen::Vector3f>(other.direction) = open_a ? toward_b_ : toward_a_;
  Lanes bounds;
  kernel(other, node, scale_, bounds);
  std::uint32_t left = at_most(bounds, limit + float_guard_, node);
  out.count = 0;
  for (; left != 0; left &= left - 1) {
    const auto k = static_cast<std::uint32_t>(std::countr_zero(left));
    const float bound = bounds.value[k] - float_guard_;
    out.pair[static_cast<std::size_t>(out.count++)] =
        open_a ? down_a(p, a_.tree, child_a, k, bound) : down_b(p, b_.tree, child_b, k, bound);
  }
}

void Placement::open_near(const SlotPair& p, float limit, SlotPairs& out) const {
  open(p, kernels_.distances, limit, out);
}

void Placement::open_overlapping(const SlotPair& p, SlotPairs& out) const {
  open(p, kernels_.gaps, 0, out);
}

}  // namespace sonde
