// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/least_room.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/effort.hpp"
#include "engine/base/round_to_nearest.hpp"
#include "engine/body/body.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/sweep/motion.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "engine/queries/pair_queries.hpp"
#include "engine/study/assembly/insertion.hpp"
#include "engine/study/assembly/sweep_slices.hpp"

namespace sonde {
namespace {

constexpr double share = 1e-3;      // of the least clearance: the tolerance
constexpr double of_radius = 1e-9;  // the tolerance is no less: this is what a sweep leaves
constexpr double of_rounding = 8;   // nor less than this
/// Units of Effort for a distance, of which the query does not say how much work it is.
constexpr int work_of_distance = 10'000;

Pose with_unit_turn(const Pose& X) { return {X.q.normalized(), X.p}; }

class Search {
 public:
  Search(const Pair& pair, const InsertionPath& way, const LeastRoom& found, std::int64_t work,
         const Progress& progress)
      : pair_(pair), way_(way), effort_(work, 0), progress_(progress), best_(found) {
    Vec3 farthest = Vec3::Zero();
    for (const Pose& X : way.poses) farthest = farthest.cwiseMax(X.p.cwiseAbs());
    const Body& probe = pair.probe();
    least_tolerance_ = std::max(of_radius * probe.mass.radius,
                                of_rounding * rounding_guard(extent(probe) + probe.mass.com.norm(),
                                                             extent(pair.fixed()), farthest));
  }

  LeastRoom run() {
    for (std::size_t i = 0; i + 1 < way_.poses.size(); ++i)
      if (!go_through(i)) return result(false);
    best_.searched = way_.travel.back();
    return result(true);
  }

 private:
  double tolerance() const { return std::max(share * best_.clearance, least_tolerance_); }

  LeastRoom result(bool complete) {
    best_.tolerance = tolerance();
    best_.complete = complete;
    return best_;
  }

  /// One piece of the way; false where the work is spent.
  bool go_through(std::size_t i) {
    const Pose from = with_unit_turn(way_.poses[i]), to = with_unit_turn(way_.poses[i + 1]);
    const Motion all(pair_.probe().mass, from, to);
    const double begin = way_.travel[i], length = way_.travel[i + 1] - begin;
    const double farthest = all.farthest(pair_.probe().mass.radius);
    SweepSlices slices;
    for (double s = 0; s < 1;) {
      best_.searched = begin + s * length;
      const double all_travel = way_.travel.back();
      report(progress_, all_travel > 0 ? best_.searched / all_travel : 0);
      const double kept = best_.clearance - tolerance();
      if (!(kept > 0)) return true;  // no clearance is less than 0
      const double end = std::min(1.0, s + slices.length());
      const Motion rest(pair_.probe().mass, all.pose_at(s), end < 1 ? all.pose_at(end) : to);
      const Sweep swept = slices.sweep(effort_, [&](Effort& effort) {
        return sweep_within_room(pair_.probe(), pair_.fixed(), rest, kept, effort);
      });
      s = swept.hit ? s + (end - s) * swept.free_until : end;
      if (effort_.is_spent()) {
        best_.searched = begin + s * length;
        return s >= 1;
      }
      if (swept.hit && !swept.given_up) s = go_down(all, i, s, farthest);
    }
    return true;
  }

  /// From where a sweep ended: down to the next minimum, if it ended at less than was found. The
  /// clearance changes no faster than the farthest point moves: returns how far it is certain to
  /// be kept.
  double go_down(const Motion& piece, std::size_t i, double s, double farthest) {
    const double here = clearance_at(piece, i, s);
    const double first_step = 0.25 * tolerance() / farthest;
    double low = s, at = s, high = s, least = here;
    for (double step = first_step; high < 1; step *= 2) {
      high = std::min(1.0, at + step);
      const double next = clearance_at(piece, i, high);
      if (next >= least || effort_.is_spent()) break;
      low = at, at = high, least = next;
    }
    // The golden section of what is left.
    constexpr double golden = 0.381966011250105;
    while (high - low > first_step && at < high && !effort_.is_spent()) {
      const bool up = high - at > at - low;
      const double probe = up ? at + golden * (high - at) : at - golden * (at - low);
      const double there = clearance_at(piece, i, probe);
      if (there < least) {
        (up ? low : high) = at;
        at = probe, least = there;
      } else {
        (up ? high : low) = probe;
      }
    }
    const double kept = best_.clearance - tolerance();
    return std::min(1.0, s + std::max(0.0, here - kept) / farthest);
  }

  /// The clearance at a place of a piece; what is less than was found is kept.
  double clearance_at(const Motion& piece, std::size_t i, double s) {
    effort_.spend(work_of_distance);
    const Pose X = piece.pose_at(s);
    const double found = distance(pair_, X).distance;
    if (found < best_.clearance) {
      best_.clearance = found;
      best_.travel = way_.travel[i] + s * (way_.travel[i + 1] - way_.travel[i]);
      best_.X_FM = X;
    }
    return found;
  }

  const Pair& pair_;
  const InsertionPath& way_;
  Effort effort_;
  const Progress& progress_;
  LeastRoom best_;
  double least_tolerance_;
};

}  // namespace

LeastRoom least_room(const Pair& pair, const InsertionPath& way, const LeastRoom& found,
                     std::int64_t work, const Progress& progress) {
  const RoundToNearest round_to_nearest;
  return Search(pair, way, found, work, progress).run();
}

}  // namespace sonde
