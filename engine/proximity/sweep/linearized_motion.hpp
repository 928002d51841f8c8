// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {

/// Bound of the displacement of the points of a probe, in terms of one of them, the centre: a point
/// at the distance r (m) from the centre has moved by at most linear + r·turn (m).
struct DisplacementBound {
  double linear = 0, turn = 0;  // m, rad
  double of(double arm) const { return linear + arm * turn; }
};

/// The first-order motion of a probe from a pose: a point with the arm r from the centre (fixed
/// frame) moves by linear + turn × r.
struct Course {
  Vec3 linear = Vec3::Zero();  ///< of the centre, m, fixed frame
  Vec3 turn = Vec3::Zero();    ///< rad, fixed frame
  Vec3 of(const Vec3& arm) const { return linear + turn.cross(arm); }
  DisplacementBound size() const { return {linear.norm(), turn.norm()}; }
};
inline Course operator*(double k, const Course& c) { return {k * c.linear, k * c.turn}; }

/// A motion, described by its first-order motion at the start (the course) and a bound of the
/// deviation from that: at the parameter s of the motion, the probe is within `bend` of s times the
/// course.
struct LinearizedMotion {
  Course course;
  DisplacementBound bend;
};
LinearizedMotion linearized(const Motion& motion, const Vec3& centre);

/// Bound of the displacement along a motion: at the parameter s, the displacement is at most s
/// times the bound.
DisplacementBound displacement_bound_along(const Motion& motion, const Vec3& centre);

/// The smallest displacement that takes the probe from one pose to another; `centre` is in its mesh
/// frame.
DisplacementBound displacement_bound(const Transform& from, const Transform& to,
                                     const Vec3& centre);

/// The deviation of a path that begins at the pose `to` from a course that begins at the pose
/// `from`: everywhere on the path, the probe is within this displacement of some pose of the course
/// (0 ≤ u ≤ 1). `arm` (m) weights turns in the choice of that pose.
DisplacementBound deviation(const Transform& from, const Course& course, const Transform& to,
                            const LinearizedMotion& path, const Vec3& centre, double arm);

}  // namespace sonde
