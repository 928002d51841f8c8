// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/feature_row.hpp"

namespace sonde {
namespace {

FeatureRowAt vertex_on_face(const FeatureRow& row, const Transform& X, const Vec3& com) {
  const Vec3 a = X * row.a;
  FeatureRowAt out{row.along_b, a - com, row.along_b.dot(a - row.b), {}, {}};
  out.d_normal.setZero();
  out.d_arm << Mat3::Zero(), -cross_matrix(out.arm);
  return out;
}

FeatureRowAt face_on_vertex(const FeatureRow& row, const Transform& X, const Vec3& com) {
  const Vec3 n = X.R * row.along_a;
  FeatureRowAt out{n, row.b - com, n.dot(X * row.a - row.b), {}, {}};
  out.d_normal << Mat3::Zero(), -cross_matrix(n);
  out.d_arm << -Mat3::Identity(), Mat3::Zero();
  return out;
}

/// The gap is measured between the points of the two lines that are nearest to each other, which
/// move along the edges as the probe moves.
FeatureRowAt edge_on_edge(const FeatureRow& row, const Transform& X, const Vec3& com) {
  const Vec3 u = X.R * row.along_a, &d = row.along_b, a = X * row.a, between = a - row.b;
  const Vec3 across = row.sign * u.cross(d);
  const double sine = across.norm();
  const Vec3 n = across / sine;
  // Square to the fixed edge, in the plane of both: what moves the probe's edge this way moves the
  // point by so much the other way along it.
  const Vec3 e = d.cross(n);
  const double ue = u.dot(e), gap = n.dot(between);
  const Vec3 p = a - u * (e.dot(between) / ue), r = p - com;
  FeatureRowAt out{n, r, gap, {}, {}};
  const Mat3 flat = Mat3::Identity() - n * n.transpose();
  out.d_normal << Mat3::Zero(), (row.sign / sine) * flat * cross_matrix(d) * cross_matrix(u);
  Eigen::Matrix<double, 1, 6> along;
  along << e.transpose(), (r.cross(e) + gap / ue * u.cross(n)).transpose();
  out.d_arm << Mat3::Zero(), -cross_matrix(r);
  out.d_arm -= u * along / ue;
  return out;
}

}  // namespace

FeatureRowAt row_at(const FeatureRow& row, const Transform& X_FM, const Vec3& com) noexcept {
  const Vec3 com_F = X_FM * com;
  switch (row.kind) {
    case FeatureRow::Kind::vertex_on_face:
      return vertex_on_face(row, X_FM, com_F);
    case FeatureRow::Kind::face_on_vertex:
      return face_on_vertex(row, X_FM, com_F);
    case FeatureRow::Kind::edge_on_edge:
      break;
  }
  return edge_on_edge(row, X_FM, com_F);
}

}  // namespace sonde
