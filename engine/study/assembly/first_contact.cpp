// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/first_contact.hpp"

#include <algorithm>
#include <limits>

#include "engine/base/error.hpp"
#include "engine/base/progress.hpp"
#include "engine/base/round_to_nearest.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/search/trivial_separation.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/motion.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "engine/proximity/triangles/triangle_pair.hpp"
#include "engine/queries/checked_pose.hpp"
#include "engine/queries/pair_queries.hpp"
#include "engine/study/assembly/insertion.hpp"
#include "engine/study/assembly/sweep_slices.hpp"

namespace sonde {
namespace {

constexpr double kept_of_radius = 1e-9;  // the gap at which a sweep stops
constexpr double aimed_at = 1e-9;        // of the travel: the tolerance
/// Sweeps at one obstacle; some 30 halve the gap down to rounding.
constexpr int most_rounds = 100;

/// One piece of a path, from one of its poses to the next. Places on it are parts of it, 0 to 1.
class PieceSearch {
 public:
  PieceSearch(const Pair& pair, const Pose& from, const Pose& to, double length, double goal)
      : pair_(pair),
        from_(from),
        to_(to),
        motion_(pair.probe().mass, from, to),
        kept_(kept_of_radius * pair.probe().mass.radius),
        near_enough_(length > 0 ? std::min(1.0, goal / length) : aimed_at) {}

  /// True if the piece is blocked, at `free()`.
  bool run(const Progress& progress) {
    while (free_ < 1 && rounds_ < most_rounds) {
      report(progress, free_);
      const double before = free_;
      if (!sweep_on()) continue;
      look_ahead();
      if (touching_ - free_ <= near_enough_) break;
      if (free_ <= before) {
        bring_touching_near();
        break;
      }
    }
    if (free_ < 1) refuse_rounding();
    return free_ < 1;
  }

  double free() const { return free_; }
  Pose pose() const { return motion_.pose_at(free_); }
  /// Where the bodies touch; infinity if no such place was found.
  double touching() const { return touching_; }

  /// The points are those at the end. Their direction is that at the first stop, where the gap is
  /// still well above rounding.
  Contact contact() const {
    const ClosestPoints points = points_at(free_), before = points_at(first_stop_);
    Contact out;
    out.on_probe = points.a;
    out.on_fixed = points.b;
    if (before.distance > 0) out.normal = before.normal;
    out.gap = points.gap;
    return out;
  }

 private:
  /// Sweeps on by a slice, but not beyond where the bodies are known to touch; false if nothing
  /// stops it.
  bool sweep_on() {
    const double all = std::min(1.0, touching_), end = std::min(all, free_ + slices_.length());
    const Body &probe = pair_.probe(), &fixed = pair_.fixed();
    const Pose from = free_ > 0 ? motion_.pose_at(free_) : from_;
    const Motion rest(probe.mass, from, end < 1 ? motion_.pose_at(end) : to_);
    // A pair that is nearer than this at the start may lose half of its gap.
    const Sweep swept = slices_.sweep(
        unlimited_, [&](Effort& effort) { return sweep(probe, fixed, rest, kept_, effort); });
    free_ = swept.hit ? free_ + (end - free_) * swept.free_until : end;
    if (!swept.hit && end >= touching_) touching_ = infinity;
    if (!swept.hit || swept.given_up) return false;
    last_ = swept;
    ++rounds_;
    if (rounds_ == 1 || points_at(free_).distance > 0.75 * kept_) first_stop_ = free_, rounds_ = 1;
    return true;
  }

  /// Looks for a place at which the bodies touch: ever farther from the free part, then half-way.
  void look_ahead() {
    if (touching_ < infinity) {
      const double half = 0.5 * (free_ + touching_);
      if (touch_at(half)) touching_ = half;
      return;
    }
    for (double step = near_enough_; step < 2; step *= 2) {
      const double at = std::min(1.0, free_ + step);
      if (touch_at(at)) return void(touching_ = at);
      if (at >= 1) return;
    }
  }
  /// Where sweeps lead no further: the gap is rounding, and only the exact test goes on.
  void bring_touching_near() {
    double apart = free_;
    while (touching_ < infinity && touching_ - apart > 0.1 * near_enough_) {
      const double half = 0.5 * (apart + touching_);
      if (!(half > apart && half < touching_)) return;
      (touch_at(half) ? touching_ : apart) = half;
    }
  }
  bool touch_at(double s) const { return touch(pair_, s < 1 ? motion_.pose_at(s) : to_); }

  /// Far out, the path is so rough that any obstacle may be rounding.
  void refuse_rounding() const {
    if (is_rough(pair_.probe(), pair_.fixed(), from_.p.cwiseAbs().cwiseMax(to_.p.cwiseAbs())))
      throw InputError("the way leads too far from the origin for the size of the probe");
  }

  ClosestPoints points_at(double s) const {
    return closest_points(
        place(Transform(motion_.pose_at(s)), corners(surface(pair_.probe()), last_.triangle_a)),
        corners(surface(pair_.fixed()), last_.triangle_b));
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  const Pair& pair_;
  Pose from_, to_;
  Motion motion_;
  double kept_;  // m
  SweepSlices slices_;
  Effort unlimited_;
  double near_enough_;
  double free_ = 0, touching_ = infinity, first_stop_ = 0;
  int rounds_ = 0;  // from the first stop at this obstacle
  Sweep last_;      // that was stopped
};

/// How far from a place of the path the bodies touch, for a piece in which none do; all that is
/// left of the path if none is found.
double travel_to_touch(const Pair& pair, const InsertionPath& way, double from) {
  const double all = way.travel.back();
  for (double step = aimed_at * all; from + step < all; step *= 2)
    if (touch(pair, pose_at(way, pair, from + step))) return step;
  return all - from;
}

}  // namespace

void check_start(const Pair& pair, const InsertionPath& way) {
  if (touch(pair, way.poses.front()))
    throw InputError::in("the way", "begins where the bodies touch or overlap: begin it outside");
}

void check_way(const Pair& pair, const InsertionPath& way, const Progress& progress) {
  check_start(pair, way);
  const auto leads_far = [&](const Pose& X) { return is_rough(pair.probe(), pair.fixed(), X.p); };
  if (std::ranges::any_of(way.poses, leads_far)) first_contact(pair, way, progress);
}

std::optional<FirstContact> first_contact(const Pair& pair, const InsertionPath& way,
                                          const Progress& progress) {
  const RoundToNearest round_to_nearest;
  check_start(pair, way);
  const double all = way.travel.back();
  for (std::size_t i = 0; i + 1 < way.poses.size(); ++i) {
    const double begin = way.travel[i], end = way.travel[i + 1], length = end - begin;
    PieceSearch piece(pair, checked_pose_of_motion(way.poses[i]),
                      checked_pose_of_motion(way.poses[i + 1]), length, aimed_at * all);
    if (!piece.run(part_of(progress, begin / all, end / all))) continue;
    FirstContact out{begin + piece.free() * length, piece.pose(), piece.contact(), 0};
    out.tolerance = piece.touching() <= 1 ? (piece.touching() - piece.free()) * length
                                          : travel_to_touch(pair, way, out.travel);
    return out;
  }
  return std::nullopt;
}

}  // namespace sonde
