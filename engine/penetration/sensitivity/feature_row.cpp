// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/feature_row.hpp"

namespace sonde {
namespace {

/// The two lines along the edges of a row.
struct Lines {
  Vec3 u, normal;  ///< direction of the probe's edge; common normal
  double sine;     ///< of the angle between them
  Vec3 e;          ///< perpendicular to the fixed edge, in the plane of both
};
Lines lines_of(const FeatureRow& row, const Transform& X) {
  const Vec3 u = X.R * row.along_a, across = row.sign * u.cross(row.along_b);
  const double sine = across.norm();
  const Vec3 n = across / sine;
  return {u, n, sine, row.along_b.cross(n)};
}

/// The gap is measured between the points of the two lines that are nearest to each other.
FeatureRowAt edge_on_edge(const FeatureRow& row, const Transform& X, const Vec3& com) {
  const Lines lines = lines_of(row, X);
  const Vec3 a = X * row.a, between = a - row.b;
  const Vec3 p = a - lines.u * (lines.e.dot(between) / lines.u.dot(lines.e));
  return {lines.normal, p - com, lines.normal.dot(between)};
}

/// If the probe's edge moves along e, the contact point moves along that edge in proportion.
FeatureRowChange change_of_edges(const FeatureRow& row, const FeatureRowAt& at,
                                 const Transform& X) {
  const Lines lines = lines_of(row, X);
  const Vec3 &n = at.normal, &r = at.arm;
  const double ue = lines.u.dot(lines.e);
  FeatureRowChange out;
  const Mat3 flat = Mat3::Identity() - n * n.transpose();
  out.normal << Mat3::Zero(),
      (row.sign / lines.sine) * flat * cross_matrix(row.along_b) * cross_matrix(lines.u);
  Eigen::Matrix<double, 1, 6> along;
  along << lines.e.transpose(), (r.cross(lines.e) + at.gap / ue * lines.u.cross(n)).transpose();
  out.arm << Mat3::Zero(), -cross_matrix(r);
  out.arm -= lines.u * along / ue;
  return out;
}

}  // namespace

FeatureRowAt row_at(const FeatureRow& row, const Transform& X_FM, const Vec3& com) noexcept {
  const Vec3 com_F = X_FM * com;
  switch (row.kind) {
    case FeatureRow::Kind::vertex_on_face: {
      const Vec3 a = X_FM * row.a;
      return {row.along_b, a - com_F, row.along_b.dot(a - row.b)};
    }
    case FeatureRow::Kind::face_on_vertex: {
      const Vec3 n = X_FM.R * row.along_a;
      return {n, row.b - com_F, n.dot(X_FM * row.a - row.b)};
    }
    case FeatureRow::Kind::edge_on_edge:
      break;
  }
  return edge_on_edge(row, X_FM, com_F);
}

FeatureRowChange row_change(const FeatureRow& row, const FeatureRowAt& at,
                            const Transform& X_FM) noexcept {
  FeatureRowChange out;
  switch (row.kind) {
    case FeatureRow::Kind::vertex_on_face:
      out.normal.setZero();
      out.arm << Mat3::Zero(), -cross_matrix(at.arm);
      return out;
    case FeatureRow::Kind::face_on_vertex:
      out.normal << Mat3::Zero(), -cross_matrix(at.normal);
      out.arm << -Mat3::Identity(), Mat3::Zero();
      return out;
    case FeatureRow::Kind::edge_on_edge:
      break;
  }
  return change_of_edges(row, at, X_FM);
}

}  // namespace sonde
