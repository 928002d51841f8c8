// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// Proof that two bodies overlap, and by how much: a point r of the probe with a ball about it
/// inside the probe, and a point p with a ball about it inside the fixed body. As long as the
/// probe's motion leaves r nearer to p than the sum of the radii, the bodies overlap. A radius may
/// be negative: then a point of the body is at most that far away. The frame has the axes of the
/// probe's principal axes at its device pose, and its origin at the centre of mass there.
struct Witness {
  Vec3 r;
  Vec3 p;
  double depth;  ///< sum of the radii, rounded down, m
};

/// A point with its depths in both bodies, where the probe is turned by R about its centre of mass.
struct CommonPoint {
  Vec3 x;           ///< in the frame of Witness, m
  Vec3 r;           ///< Rᵀ x, the point of the probe
  double a, b;      ///< its depths in the probe and in the fixed body, rounded down, m
  Vec3 up_a, up_b;  ///< unit; the directions in which these depths grow
  double depth() const { return a + b; }
  Vec3 up() const { return up_a + up_b; }
  Witness witness() const { return {r, x, a + b}; }
};

/// The depths of points in a probe and in a fixed body: the distance from the body's triangles,
/// negative outside, and negative everywhere if the body is a surface. Each depth has Lipschitz
/// constant 1, so a separating motion displaces a point that is deep in both by at least the sum.
class CommonDepth {
 public:
  CommonDepth(const Body& probe, const Body& fixed, const Pose& X_FM);

  CommonPoint at(const Mat3& R, const Vec3& x) const;
  /// The same, given the result at a point near by (at the same R), which may save the inside
  /// tests.
  CommonPoint at(const Mat3& R, const Vec3& x, const CommonPoint& known) const;
  /// Ascends from `start` to a deeper point, with steps of about `stride` (m), in `evaluations`
  /// evaluations; three times as many while no depth is positive.
  CommonPoint ascend(const Mat3& R, const CommonPoint& start, double stride, int evaluations) const;

  const Body& probe() const { return probe_; }
  const Body& fixed() const { return fixed_; }
  const Transform& X_FM() const { return X_FM_; }
  const Transform& X_MW() const { return X_MW_; }  ///< W: the frame of Witness
  const Transform& X_FW() const { return X_FW_; }
  int evaluations() const { return evaluations_; }  ///< number of evaluations so far

 private:
  struct Side {
    double depth;
    Vec3 up;
  };
  Side side(const Body& body, const Vec3& x, double known) const;
  CommonPoint evaluate(const Mat3& R, const Vec3& x, double known_a, double known_b) const;

  const Body& probe_;
  const Body& fixed_;
  Transform X_FM_, X_MW_, X_FW_;
  double guard_;
  mutable int evaluations_ = 0;
};

}  // namespace sonde
