// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/sweep/motion.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// How far s may advance until `slack` could have been used up by a gap that changes at `speed`
/// (negative: closing) with an acceleration of at most `acceleration`. Units of s.
double safe_advance(double slack, double speed, double acceleration);

/// The motion at one s.
struct Moment {
  Transform X;
  Motion::Velocity velocity;
  Moment() = default;
  Moment(const Motion& motion, double s) : X(motion.at(s)), velocity(motion.velocity(s)) {}
};

/// Advances pairs of triangles along one motion and keeps the earliest stop.
class PairSweep {
 public:
  PairSweep(const Body& a, const Body& b, const Motion& motion, double clearance);

  /// The pair (i, j), known to be free on [0, from]. `normal`: a direction to try first (zero:
  /// none); holds the last one found on return. Returns what it took, in the units of Effort.
  int advance(std::uint32_t i, std::uint32_t j, double from, Vec3& normal);

  struct Step {
    double gap;     ///< along the normal, m
    double length;  ///< of s
    bool closing;   ///< the corner that allows no more comes nearer
  };
  /// How far from one moment on the pair is certain to keep the clearance along a normal; 0 where
  /// it does not have it then.
  Step step_along(std::uint32_t i, std::uint32_t j, const Vec3& normal, const Moment& now) const;

  /// A pair was found to be so far apart at the start, m.
  void saw_at_start(double distance) { nearest_ = std::min(nearest_, distance); }
  /// The gap along a direction that a pair may come down to on the path, m, that has this much at
  /// its start: what is nearer than asked from the start may slide, or move away, on half of what
  /// it has. A small gap along some direction does not say that: the nearest pair seen does.
  double floor_of(double gap) const {
    return std::min(clearance_, 0.5 * std::max(gap, nearest_)) + guard_;
  }
  /// By how much a path hangs at most below the straight line between two heights, that bends
  /// upwards by so much (per unit of s squared, as Motion::bend tells): half-way, an eighth.
  double hangs_by(double bend) const {
    const double radius = a_.mass.radius;
    return 0.125 * std::min(bend + motion_.bend_error() * radius,
                            motion_.acceleration_per_radius() * radius);
  }
  /// Is the pair certain to keep its clearance along a normal as far as the path is followed?
  bool is_clear_along(std::uint32_t i, std::uint32_t j, const Vec3& normal);
  /// The same from s on, `now`, along a direction that turns from one normal, that separates the
  /// pair then, to another at the end of the path.
  bool is_clear_between(std::uint32_t i, std::uint32_t j, double s, const Moment& now,
                        const Vec3& from, const Vec3& to);

  /// The path is followed no further: all that was not looked at is free up to `known`.
  void give_up(double known) {
    if (known < result_.free_until) result_ = {.free_until = known, .hit = true, .given_up = true};
  }

  const Sweep& result() const { return result_; }
  double free_until() const { return result_.free_until; }
  const Moment& start() const { return start_; }
  const Transform& end() const { return end_; }
  /// The moment at s; the last one asked for is kept.
  const Moment& at(double s);
  double guard() const { return guard_; }
  double clearance() const { return clearance_; }

 private:
  struct Slide {
    double s;
    const Moment& moment;
    const Vec3& normal;  ///< that separates the pair then
  };
  /// Is the pair certain to keep so much between two moments, along a direction that turns from one
  /// to the other?
  bool slides(const Slide& from, const Slide& to, const Corners& local, const Corners& tb,
              double radius, double floor) const;
  /// Along n the triangle is as far as its corners are: each is given the time that its own height
  /// over B and its own speed allow.
  Step step_along(const Vec3& n, const Moment& now, const Corners& local, const Corners& ta,
                  const Corners& tb, double radius, double floor) const;
  /// The largest distance of a corner from the centre of mass, m.
  double radius(const Corners& local) const;

  const Body& a_;
  const Body& b_;
  const Motion& motion_;
  double clearance_;
  double guard_;                                              // rounding error of a gap, m
  double nearest_ = std::numeric_limits<double>::infinity();  // seen at the start, m
  Moment start_, kept_;
  Transform end_;
  double kept_s_ = 0;
  Sweep result_;
};

}  // namespace sonde
