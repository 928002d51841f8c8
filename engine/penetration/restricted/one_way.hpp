// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/geometry/transform.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// The poses of a probe on one way from X_FM: along a straight line, by s metres, or about an axis,
/// by s radians.
class OneWay {
 public:
  /// @pre The direction is unit, in the fixed frame.
  static OneWay along(const Pose& X_FM, const Vec3& direction_F);
  /// @pre The axis is unit; both are in the fixed frame.
  static OneWay about(const Pose& X_FM, const Vec3& point_F, const Vec3& axis_F);

  Pose at(double s) const;
  /// The same way, the other way round.
  OneWay back() const;
  /// m per unit of s: no point at `radius` (m) from `center` (mesh frame) is quicker.
  double speed(const Vec3& center, double radius) const;
  bool turns() const { return turns_; }

  /// A part of the way.
  struct Stretch {
    Stretch(double first, double last);
    double from, to;
    double cosine, sine;  ///< of its middle
  };
  /// Adds to `out` all s within a stretch at which two triangles may begin or cease to meet:
  /// a corner comes into the plane of the other, or two edges into one plane, or, where both lie in
  /// one plane all along, a corner comes onto a line of the other's sides. `a` is the probe's
  /// triangle at X_FM, both are in F. `flat` (m): what is in the other's plane to that stays there.
  void events(const Corners& a, const Corners& b, const Stretch& stretch, double flat,
              std::vector<double>& out) const;

 private:
  /// How a coordinate changes on the way: even cos s + odd sin s + rest, or even + odd s.
  struct Course {
    double even = 0, odd = 0, rest = 0;
    Course operator-(const Course& o) const { return {even - o.even, odd - o.odd, rest - o.rest}; }
  };
  /// n · x(s) of a point with x(0) = x.
  Course of_point(const Vec3& n, const Vec3& x) const;
  /// n(s) · b, of a direction that goes with the probe from a point x(s) of it: n(s) · (b − x(s)).
  Course of_plane(const Vec3& n, const Vec3& x, const Vec3& b) const;
  /// (e(s) × f) · (q − p(s)).
  Course of_edges(const Vec3& p, const Vec3& e, const Vec3& q, const Vec3& f) const;
  /// n · R(s) w.
  Course of_turned(const Vec3& n, const Vec3& w) const;
  void add_roots(const Course& course, const Stretch& stretch, std::vector<double>& out) const;
  /// A triangle of the probe at X_FM, as it is at s.
  Corners moved(const Corners& a, double s) const;

  Pose start_;
  bool turns_ = false;
  Vec3 way_ = Vec3::UnitZ();   // unit: of the line, or the axis
  Vec3 point_ = Vec3::Zero();  // on the axis, F
};

}  // namespace sonde
