// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/geometry/transform.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// The poses of a probe on a one-parameter motion from X_FM: a translation along a line, by s
/// metres, or a rotation about an axis, by s radians.
class OneDofMotion {
 public:
  /// @pre The direction is unit, in the fixed frame.
  static OneDofMotion along(const Pose& X_FM, const Vec3& direction_F);
  /// @pre The axis is unit; both are in the fixed frame.
  static OneDofMotion about(const Pose& X_FM, const Vec3& point_F, const Vec3& axis_F);

  Pose at(double s) const;
  /// The same motion in the opposite direction.
  OneDofMotion back() const;
  /// m per unit of s: upper bound of the speed of points within `radius` (m) of `center` (mesh
  /// frame).
  double speed(const Vec3& center, double radius) const;
  bool turns() const { return turns_; }

  /// An interval of s.
  struct Interval {
    Interval(double first, double last);
    double from, to;
    double cosine, sine;  ///< of the middle of the interval
  };
  /// Adds to `out` all s within an interval at which two triangles may begin or cease to intersect:
  /// a corner passes through the plane of the other triangle, or two edges become coplanar, or, if
  /// both triangles stay in one plane, a corner passes over the line of a side of the other. `a` is
  /// the probe's triangle at X_FM; both are in F. `flat` (m): a corner within this distance of the
  /// other's plane counts as in it.
  void events(const Corners& a, const Corners& b, const Interval& interval, double flat,
              std::vector<double>& out) const;

 private:
  /// A coordinate as a function of s: even cos s + odd sin s + rest, or even + odd s.
  struct Coordinate {
    double even = 0, odd = 0, rest = 0;
    Coordinate operator-(const Coordinate& o) const {
      return {even - o.even, odd - o.odd, rest - o.rest};
    }
  };
  /// n · x(s) of a point with x(0) = x.
  Coordinate of_point(const Vec3& n, const Vec3& x) const;
  /// n(s) · (b − x(s)), where the normal n and the point x move with the probe.
  Coordinate of_plane(const Vec3& n, const Vec3& x, const Vec3& b) const;
  /// (e(s) × f) · (q − p(s)).
  Coordinate of_edges(const Vec3& p, const Vec3& e, const Vec3& q, const Vec3& f) const;
  /// n · R(s) w.
  Coordinate of_turned(const Vec3& n, const Vec3& w) const;
  void add_roots(const Coordinate& coordinate, const Interval& interval,
                 std::vector<double>& out) const;
  /// A triangle of the probe at s; `a` is the same triangle at X_FM.
  Corners moved(const Corners& a, double s) const;

  Pose start_;
  bool turns_ = false;
  Vec3 direction_ = Vec3::UnitZ();  // unit: direction of the line or of the axis
  Vec3 point_ = Vec3::Zero();       // on the axis, F
};

}  // namespace sonde
