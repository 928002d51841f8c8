// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {

Float4 to_float(const Vec3& x) {
  return Float4{static_cast<float>(x.x()), static_cast<float>(x.y()), static_cast<float>(x.z()), 0};
}

/// Every coordinate that a comparison of boxes passes through is at most the sum of the extents;
/// about ten operations, each rounding by 2⁻²⁴ of that, and rotation entries off by as much.
float float_rounding(double extent_a, double extent_b, const Vec3& p) {
  const double size = extent_a + extent_b + p.cwiseAbs().maxCoeff();
  return static_cast<float>(40 * 0x1p-24 * size);
}

}  // namespace

double extent(const Body& body) {
  const Tree::Node& root = body.tree.nodes.front();
  return (center(root).cwiseAbs() + half_size(root)).maxCoeff();
}

Placement::Placement(const Body& a, const Body& b, const Transform& X_BA)
    : X(X_BA),
      guard(rounding_guard(extent(a), extent(b), X_BA.p)),
      a_(&a),
      b_(&b),
      shift_(to_float(X_BA.p)),
      float_guard_(float_rounding(extent(a), extent(b), X_BA.p)) {
  const Mat3 abs_R = X_BA.R.cwiseAbs();
  for (int i = 0; i < 3; ++i) {
    columns_[i] = to_float(X_BA.R.col(i));
    abs_columns_[i] = to_float(abs_R.col(i));
    rows_[i] = to_float(X_BA.R.row(i).transpose());
    abs_rows_[i] = to_float(abs_R.row(i).transpose());
  }
}

Placement::BoxGap Placement::box_gap_at(const Transform& X, double guard, const Tree::Node& na,
                                        const Tree::Node& nb) {
  const Vec3 ha = half_size(na), hb = half_size(nb);
  const Vec3 d = X * center(na) - center(nb);
  const Vec3 d_a = X.R.transpose() * d;
  const Mat3 abs_R = X.R.cwiseAbs();
  int i = 0, j = 0;
  const double in_b = (d.cwiseAbs() - hb - abs_R * ha).maxCoeff(&i);
  const double in_a = (d_a.cwiseAbs() - ha - abs_R.transpose() * hb).maxCoeff(&j);
  if (in_b >= in_a) return {in_b - guard, (d[i] < 0 ? -1.0 : 1.0) * Vec3::Unit(i)};
  return {in_a - guard, (d_a[j] < 0 ? -1.0 : 1.0) * X.R.col(j)};
}

}  // namespace sonde
