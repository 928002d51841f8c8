// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// A box of rotations. Every unit quaternion, up to its sign, has a positive largest component (w,
/// x, y, z). Divided by it, the other three lie within ±1 (the face of a cube in four dimensions).
/// Turns by 180° are as regular there as any other, and the effect of a box of them on a point has
/// an exact bound.
struct RotationCell {
  /// A lower bound, and a quaternion of the cell (not of unit length) whose value is near it.
  struct Least {
    double bound;
    Eigen::Vector4d at;
  };

  int face = 0;                               ///< which component is 1
  std::array<double, 3> at{}, half{1, 1, 1};  ///< of the other three, in the order w, x, y, z

  /// The quaternion in the middle, not of unit length: w, x, y, z.
  Eigen::Vector4d middle() const;
  /// The least 4 vᵀÎv of the cell, v the vector part of its unit quaternions; m², for an inertia Î
  /// (principal, ascending) in m².
  double least_cost(const Vec3& inertia) const;
  /// A lower bound of qᵀSq / qᵀq over the cell's quaternions q, for a symmetric S. Its slack falls
  /// with the square of the cell's size. `guess`, a quaternion near the least, makes it tighter.
  /// Rounded down.
  Least least_quotient(const Eigen::Matrix4d& S, const Eigen::Vector4d& guess) const;
  /// About how much 4 vᵀÎv changes from the middle to the side across one component.
  double cost_along(int component, const Vec3& inertia) const;
  /// The two halves across one of the three components.
  std::array<RotationCell, 2> halves(int component) const;
};

/// G with |R r − p|² = qᵀGq / qᵀq for the turn R of a quaternion q = (w, x, y, z); m² for m.
Eigen::Matrix4d distance_form(const Vec3& r, const Vec3& p);

/// How far the turns of a cell take points from where its middle takes them.
class CellSpread {
 public:
  explicit CellSpread(const RotationCell& cell);
  const Mat3& middle() const { return R_; }
  /// No turn R of the cell takes r further from middle() r than this, in the unit of r.
  double reach(const Vec3& r) const;
  /// The share of one component in that.
  double reach_along(int component, const Vec3& r) const {
    return axis_[component].cross(r).norm();
  }

 private:
  Mat3 R_;
  Vec3 axis_[3];  // R r = middle (r + 2 u×r + …): 2u for the whole half side of each component
};

}  // namespace sonde
