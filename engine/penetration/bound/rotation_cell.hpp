// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// A box of rotations. Up to its sign, every unit quaternion has a positive largest component (w,
/// x, y or z). Divided by it, the other three lie within ±1 (a face of a cube in four dimensions).
/// Turns by 180° are not singular in these coordinates, and the effect of a box of turns on a point
/// has an exact bound.
struct RotationCell {
  /// A lower bound, and a quaternion of the cell (not of unit length) at which the value is near
  /// it.
  struct Least {
    double bound;
    Eigen::Vector4d at;
  };

  int face = 0;                               ///< which component is 1
  std::array<double, 3> at{}, half{1, 1, 1};  ///< centre and half width of the others

  /// The quaternion at the centre, (w, x, y, z), not of unit length.
  Eigen::Vector4d middle() const;
  /// The minimum of 4 vᵀÎv over the cell, m², where v is the vector part of its unit quaternions
  /// and Î the inertia (principal, ascending), m².
  double least_cost(const Vec3& inertia) const;
  /// A lower bound of qᵀSq / qᵀq over the cell's quaternions q, for a symmetric S, rounded down.
  /// Its slack decreases with the square of the cell's size. `guess`, a quaternion near the
  /// minimum, makes it tighter.
  Least least_quotient(const Eigen::Matrix4d& S, const Eigen::Vector4d& guess) const;
  /// Approximate change of 4 vᵀÎv from the middle to the side along one component.
  double cost_along(int component, const Vec3& inertia) const;
  /// The two halves across one of the three components.
  std::array<RotationCell, 2> halves(int component) const;
};

/// G with |R r − p|² = qᵀGq / qᵀq for the turn R of a quaternion q = (w, x, y, z). In m² if r and p
/// are in m.
Eigen::Matrix4d distance_form(const Vec3& r, const Vec3& p);

/// Bounds how far the rotations of a cell displace a point from its position under the rotation at
/// the cell's middle.
class CellSpread {
 public:
  explicit CellSpread(const RotationCell& cell);
  const Mat3& middle() const { return R_; }
  /// Upper bound of |R r − middle() r| over the turns R of the cell, in the unit of r.
  double reach(const Vec3& r) const;
  /// The contribution of one component to that bound.
  double reach_along(int component, const Vec3& r) const {
    return axis_[component].cross(r).norm();
  }

 private:
  Mat3 R_;
  Vec3 axis_[3];  // R r = middle (r + 2 u×r + …): 2u for the half width of each component
};

}  // namespace sonde
