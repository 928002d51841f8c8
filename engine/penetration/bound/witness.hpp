// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"

namespace sonde {

/// What shows that two bodies overlap, and by how much: a point r of the probe with a ball about it
/// that belongs to the probe, and a point p with a ball about it that belongs to the fixed body. As
/// long as the motion of the probe leaves r nearer to p than the sum of the radii, they overlap. A
/// radius may be negative: then a point of the body is no further away than that. The frame is that
/// of the probe's principal axes at its device pose, the origin its centre of mass there.
struct Witness {
  Vec3 r;
  Vec3 p;
  double depth;  ///< sum of the radii, rounded down, m
};

/// A point of both bodies, the probe being turned by R about its centre of mass.
struct CommonPoint {
  Vec3 x;           ///< in the frame of Witness, m
  Vec3 r;           ///< Rᵀ x, the point of the probe
  double a, b;      ///< how deep it lies in the probe and in the fixed body, rounded down, m
  Vec3 up_a, up_b;  ///< unit: where these grow
  double depth() const { return a + b; }
  Vec3 up() const { return up_a + up_b; }
  Witness witness() const { return {r, x, a + b}; }
};

/// How deep points lie in a probe and in a fixed body: their distance from its triangles, negative
/// outside, and everywhere where the body is a surface. Each changes by no more than the point is
/// moved by, so what is deep in both must be moved by the sum, wherever the probe goes.
class CommonDepth {
 public:
  CommonDepth(const Body& probe, const Body& fixed, const Pose& X_FM);

  CommonPoint at(const Mat3& R, const Vec3& x) const;
  /// The same from a point near by (at the same R), which may tell the side.
  CommonPoint at(const Mat3& R, const Vec3& x, const CommonPoint& known) const;
  /// A deeper point, uphill from one with strides of about so much (m), by so many evaluations;
  /// three times as many as long as none of positive depth is found.
  CommonPoint ascend(const Mat3& R, const CommonPoint& start, double stride, int evaluations) const;

  const Body& probe() const { return probe_; }
  const Body& fixed() const { return fixed_; }
  const Transform& X_FM() const { return X_FM_; }
  const Transform& X_MW() const { return X_MW_; }  ///< W: the frame of Witness
  const Transform& X_FW() const { return X_FW_; }
  int evaluations() const { return evaluations_; }  ///< so far

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
