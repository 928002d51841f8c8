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

/// The advance of s within which a gap cannot lose more than `slack`. The gap changes at `speed`
/// (negative: closing) with an acceleration of at most `acceleration`. Units of s.
double safe_advance(double slack, double speed, double acceleration);

/// The motion at one s.
struct Moment {
  Transform X;
  Motion::Velocity velocity;
  Moment() = default;
  Moment(const Motion& motion, double s) : X(motion.at(s)), velocity(motion.velocity(s)) {}
};

/// What a pair must keep that is nearer than the clearance, or not much farther, at the start.
enum class PairsKeep {
  half_of_start,  ///< half of its gap: it may slide or move away
  all,            ///< all of the clearance, as everywhere: else the path ends at the start
};

/// Whether a height that is `from` and `to` above a floor at the ends of a path, and lies below the
/// chord between them by at most `sag` at the middle (its upward curvature is at most 8 `sag`),
/// stays above the floor. With the most curvature it is a parabola, (1−s)² from + 2 s (1−s) m +
/// s² to, m = (from + to)/2 − 2 sag, and that is ≥ 0 on [0, 1] if and only if m ≥ −√(from · to).
bool stays_above(double from, double to, double sag);

/// Advances pairs of triangles along one motion and keeps the earliest stop.
class PairSweep {
 public:
  PairSweep(const Body& a, const Body& b, const Motion& motion, double clearance,
            PairsKeep keep = PairsKeep::half_of_start);

  /// Advances the pair (i, j), known to be free on [0, from]. `normal`: a direction to try first
  /// (zero: none); returns the last direction found in it. Returns the work, in units of Effort.
  int advance(std::uint32_t i, std::uint32_t j, double from, Vec3& normal);

  struct Step {
    double gap;     ///< along the normal, m
    double length;  ///< in units of s
    bool closing;   ///< the corner that limits the step is approaching
  };
  /// The step from the given moment in which the pair certainly keeps the clearance along a normal;
  /// 0 if it does not have the clearance at that moment.
  Step step_along(std::uint32_t i, std::uint32_t j, const Vec3& normal, const Moment& now) const;

  /// Reports the distance of a pair at the start, m.
  void saw_at_start(double distance) { nearest_ = std::min(nearest_, distance); }
  /// m: the gap along a direction that a pair must keep on the path, if it has `gap` along it at
  /// the start. This is the clearance, or less for a pair that is nearer at the start: such a pair
  /// may slide or move away with half of its gap. But a small gap along one direction does not
  /// prove that the pair is so near; only the nearest distance reported at the start does.
  double floor_of(double gap) const {
    if (keep_ == PairsKeep::all) return clearance_ + guard_;
    return std::min(clearance_, 0.5 * std::max(gap, nearest_)) + guard_;
  }
  /// m: how far a path of heights can lie below the chord between its ends. `bend` is the upward
  /// curvature (per unit of s squared, from Motion::bend): at the middle, it lies below the chord
  /// by an eighth of that.
  double hangs_by(double bend) const {
    const double radius = a_.mass.radius;
    return 0.125 * std::min(bend + motion_.bend_error() * radius,
                            motion_.acceleration_per_radius() * radius);
  }
  /// Whether the pair is certain to keep its clearance along a normal up to the stop found so far.
  bool is_clear_along(std::uint32_t i, std::uint32_t j, const Vec3& normal);
  /// The same from s on (`now`), along a direction that turns from the normal `from`, which
  /// separates the pair at s, to the normal `to` at the end of the path.
  bool is_clear_between(std::uint32_t i, std::uint32_t j, double s, const Moment& now,
                        const Vec3& from, const Vec3& to);

  /// Ends the sweep: everything not yet examined is free up to `known`.
  void give_up(double known) {
    if (known < result_.free_until) result_ = {.free_until = known, .hit = true, .given_up = true};
  }

  const Sweep& result() const { return result_; }
  double free_until() const { return result_.free_until; }
  const Moment& start() const { return start_; }
  const Transform& end() const { return end_; }
  /// The moment at s; the last one is cached.
  const Moment& at(double s);
  double guard() const { return guard_; }
  double clearance() const { return clearance_; }

 private:
  struct Slide {
    double s;
    const Moment& moment;
    const Vec3& normal;  ///< separates the pair at that moment
  };
  /// Whether the pair is certain to keep the gap `floor` between two moments, along a direction
  /// that turns from one normal to the other.
  bool slides(const Slide& from, const Slide& to, const Corners& local, const Corners& tb,
              double radius, double floor) const;
  /// The step along n: the minimum over the corners of A, each advanced by its own height over B
  /// and its own speed.
  Step step_along(const Vec3& n, const Moment& now, const Corners& local, const Corners& ta,
                  const Corners& tb, double radius, double floor) const;
  /// The largest distance of a corner from the centre of mass, m.
  double radius(const Corners& local) const;

  const Body& a_;
  const Body& b_;
  const Motion& motion_;
  double clearance_;
  PairsKeep keep_;
  double guard_;  // rounding error of a gap, m
  // m: least distance reported at the start.
  double nearest_ = std::numeric_limits<double>::infinity();
  Moment start_, kept_;
  Transform end_;
  double kept_s_ = 0;
  Sweep result_;
};

}  // namespace sonde
