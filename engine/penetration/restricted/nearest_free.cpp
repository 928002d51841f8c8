// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/restricted/nearest_free.hpp"

#include <algorithm>
#include <memory>
#include <tuple>
#include <vector>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

/// Share of R: travel of the farthest point in the first interval. The pairs of an interval are
/// collected in one traversal. (On knots of 1600 triangles, a constant 0.01 or 0.1 for all
/// intervals took 1.5 times as long.)
constexpr double first_interval = 0.03;
/// Pairs examined in an interval: with fewer, the next interval is twice as long, with more half as
/// long. So a small probe crosses a large body in few intervals, and the pairs of fine meshes are
/// not all examined at once.
constexpr std::size_t few_pairs = 64, many_pairs = 16384;
constexpr double shortest_interval = first_interval / 64;  ///< where surfaces lie on each other
/// Pairs between two progress reports: some milliseconds.
constexpr std::size_t pairs_per_report = 16384;

/// Two triangles intersect for s in [from, to].
struct Blocked {
  double from, to;
  std::uint32_t a, b;
};

class Walk {
 public:
  Walk(const Body& probe, const Body& fixed, const OneDofMotion& motion)
      : probe_(probe),
        fixed_(fixed),
        motion_(motion),
        start_(motion.at(0)),
        speed_(motion.speed(probe.mass.com, probe.mass.radius)),
        stack_(std::make_unique<PairStack<SlotPair>>()) {}

  std::optional<FirstFree> run(double most, const Progress& progress) {
    const double whole = probe_.mass.radius / speed_;
    double step = first_interval * whole;
    for (double from = 0; from < most;) {
      const auto tell = [&] { report(progress, from / most); };
      tell();
      const double to = std::min(most, from + step);
      const std::size_t looked_at = find_blocked({from, to}, tell);
      if (auto found = first_gap(from, to)) return found;
      from = to;
      if (looked_at < few_pairs) step *= 2;
      if (looked_at > many_pairs) step = std::max(0.5 * step, shortest_interval * whole);
    }
    return std::nullopt;
  }

 private:
  /// Returns the number of pairs that it examined.
  std::size_t find_blocked(const OneDofMotion::Interval& interval, const auto& tell) {
    const double from = interval.from, to = interval.to;
    blocked_.clear();
    const double middle = 0.5 * (from + to);
    const Placement placement(probe_, fixed_, Transform(motion_.at(middle)));
    guard_ = placement.guard;
    const double near = 0.5 * (to - from) * speed_ + guard_;
    const float reach = placement.to_unit_rounded_up(near);
    stack_->clear();
    stack_->push(placement.roots());
    SlotPairs found;
    std::size_t looked_at = 0;
    while (!stack_->empty()) {
      const SlotPair p = stack_->pop();
      if (placement.is_leaf(p)) {
        if (++looked_at % pairs_per_report == 0) tell();
        const std::uint32_t a = placement.triangle_a(p), b = placement.triangle_b(p);
        if (closest_points(placement.corners_a(a), placement.corners_b(b), near).distance <= near)
          add_pair(a, b, interval);
        continue;
      }
      found.count = 0;
      placement.open_by_faces(p, reach, found);
      for (const SlotPair& q : found) stack_->push(q);
    }
    ordering::sort(blocked_, [](const Blocked& x, const Blocked& y) {
      return std::tie(x.from, x.to, x.a, x.b) < std::tie(y.from, y.to, y.a, y.b);
    });
    return looked_at;
  }

  void add_pair(std::uint32_t a, std::uint32_t b, const OneDofMotion::Interval& interval) {
    const Corners on_a = corners(surface(probe_), a), on_b = corners(surface(fixed_), b);
    events_.assign({interval.from, interval.to});
    motion_.events(place(start_, on_a), on_b, interval, guard_, events_);
    ordering::sort(events_);
    bool before = false;
    for (std::size_t i = 1; i < events_.size(); ++i) {
      if (!(events_[i] > events_[i - 1])) continue;
      const Corners moved = place(Transform(motion_.at(0.5 * (events_[i - 1] + events_[i]))), on_a);
      const Meeting meeting = classify(moved, on_b);
      const bool met = meeting == Meeting::meeting ||
                       (meeting == Meeting::doubtful && meet_exactly(moved, on_b));
      if (met && before)
        blocked_.back().to = events_[i];
      else if (met)
        blocked_.push_back({events_[i - 1], events_[i], a, b});
      before = met;
    }
  }

  std::optional<FirstFree> first_gap(double from, double to) {
    double reached = from;
    for (std::size_t i = 0; i <= blocked_.size(); ++i) {
      const double next = i < blocked_.size() ? blocked_[i].from : to;
      if (next > reached)
        if (auto found = free_between(reached, next)) return found;
      if (i < blocked_.size() && blocked_[i].to > reached) {
        reached = blocked_[i].to;
        last_.triangle_a = blocked_[i].a;
        last_.triangle_b = blocked_[i].b;
      }
    }
    return std::nullopt;
  }

  /// No triangles intersect in this interval, so it is free unless one body is within the other.
  std::optional<FirstFree> free_between(double from, double to) {
    for (double beyond = guard_ / speed_; from + beyond < to; beyond *= 2) {
      FirstFree out = last_;
      out.s = from + beyond;
      out.X_FM = motion_.at(out.s);
      if (!overlap(probe_, fixed_, Transform(out.X_FM), Doubt::exact)) return out;
    }
    return std::nullopt;
  }

  const Body& probe_;
  const Body& fixed_;
  const OneDofMotion& motion_;
  Transform start_;
  double speed_;      // m per unit of s, of the fastest point
  double guard_ = 0;  // m: rounding error of coordinates
  FirstFree last_;
  std::unique_ptr<PairStack<SlotPair>> stack_;
  std::vector<Blocked> blocked_;
  std::vector<double> events_;
};

}  // namespace

std::optional<FirstFree> nearest_free(const Body& probe, const Body& fixed,
                                      const OneDofMotion& motion, double most,
                                      const Progress& progress) {
  return Walk(probe, fixed, motion).run(most, progress);
}

}  // namespace sonde
