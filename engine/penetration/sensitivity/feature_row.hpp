// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// Two features of the bodies that face each other. As long as they do, the gap between them is a
/// smooth function of the probe's pose.
struct FeatureRow {
  enum class Kind { vertex_on_face, face_on_vertex, edge_on_edge };  ///< the probe's feature first
  Kind kind;
  /// Probe's mesh frame, m: its vertex; a point of its face, and the unit normal; a point of its
  /// edge, and the unit direction. A normal points from the fixed body to the probe.
  Vec3 a, along_a;
  /// The same for the fixed body, in its mesh frame F.
  Vec3 b, along_b;
  double sign;  ///< of edges: the normal is along sign·(u × d)
};

/// A row at a pose. A small motion of the probe is (ξ, ψ): displacement of its centre of mass, m,
/// and rotation vector, rad, both in F.
struct FeatureRowAt {
  Vec3 normal;  ///< n, unit, from the fixed body to the probe, F
  Vec3 arm;     ///< r, from the probe's centre of mass to where the gap is measured, F, m
  double gap;   ///< m; it changes by n·ξ + (r × n)·ψ
};
/// The derivatives of a row's normal and arm with respect to (ξ, ψ).
struct FeatureRowChange {
  Eigen::Matrix<double, 3, 6> normal, arm;
};

/// `com`: the probe's centre of mass in its mesh frame.
FeatureRowAt row_at(const FeatureRow& row, const Transform& X_FM, const Vec3& com) noexcept;
/// The derivatives at `at`, the values of the row at X_FM.
FeatureRowChange row_change(const FeatureRow& row, const FeatureRowAt& at,
                            const Transform& X_FM) noexcept;

/// The skew-symmetric matrix of v ×.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

}  // namespace sonde
