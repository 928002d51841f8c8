// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {

/// How far a probe has moved, seen from one of its points, the centre: no point of it at a distance
/// r from the centre is further than linear + r·turn from where it was.
struct Displacement {
  double linear = 0, turn = 0;  // m, rad
  double of(double arm) const { return linear + arm * turn; }
};

/// Where a probe goes from a pose, to first order: a point with the arm r from the centre (fixed
/// frame) goes by linear + turn × r.
struct Course {
  Vec3 linear = Vec3::Zero();  ///< of the centre, m, fixed frame
  Vec3 turn = Vec3::Zero();    ///< rad, fixed frame
  Vec3 of(const Vec3& arm) const { return linear + turn.cross(arm); }
  Displacement size() const { return {linear.norm(), turn.norm()}; }
};
inline Course operator*(double k, const Course& c) { return {k * c.linear, k * c.turn}; }

/// The course of a motion's start, and how far its poses may be from it anywhere, at most. At s of
/// the motion the probe is as far along the course.
struct Path {
  Course course;
  Displacement bend;
};
Path path_of(const Motion& motion, const Vec3& centre);

/// How far the probe goes along a motion, at most; at s of it, by no more than s times that.
Displacement displacement_along(const Motion& motion, const Vec3& centre);

/// The least displacement that takes the probe from one pose to another, the centre in its mesh
/// frame.
Displacement displacement(const Transform& from, const Transform& to, const Vec3& centre);

/// A path from the pose `to` on, and a course from the pose `from`: on all of the path the probe is
/// no further than that from some pose of the course (of which there are those from u = 0 to 1; the
/// one that is chosen weighs a turn by `arm`, m).
Displacement deviation(const Transform& from, const Course& course, const Transform& to,
                       const Path& path, const Vec3& centre, double arm);

}  // namespace sonde
