// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/leap_descent.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/phase_timer.hpp"
#include "engine/penetration/descent/descent_tuning.hpp"
#include "engine/penetration/descent/leap_tuning.hpp"
#include "engine/proximity/queries/intersect.hpp"

namespace sonde {
namespace {

constexpr const LeapTuning& leaps = leap_tuning;

constexpr ContactRows::Finding few{.most_pairs = leaps.few_pairs, .keeps_lists = false};
constexpr ContactRows::Finding many{.most_pairs = leaps.many_pairs, .keeps_lists = false};

/// Shortens a step so that |y| decreases along all of it, its turn is within bounds, and it is no
/// longer than `trust` (m).
Vec6 worth_trying(const Chart& chart, const Vec6& y, Vec6 step, double trust) {
  if (!(step.squaredNorm() > 0)) return Vec6::Zero();

  step *= std::clamp(-y.dot(step) / step.squaredNorm(), 0.0, 1.0);
  const double turn = chart.v(step).norm(), length = step.norm();
  step *= std::min(
      {1.0, descent_tuning.largest_turn / std::max(turn, 1e-30), trust / std::max(length, 1e-300)});
  const double limit = std::max(Chart::largest_v, chart.v(y).norm());
  while (chart.v(y + step).norm() > limit) step *= 0.5;
  return step;
}

}  // namespace

/// Predictions for the next leap, from the leaps so far.
struct LeapDescent::Pace {
  double trust;    ///< m: trust region, the longest leap allowed
  double bending;  ///< κ, 1/m: contacts bend into a leap by about κ|leap|²
  bool complete;   ///< the rows are of the bodies themselves, so missing rows are searched for
  double moved = 0;
};

LeapDescent::LeapDescent(const Body& probe, const Body& fixed, Method method)
    : probe_(probe), fixed_(fixed), method_(method) {}

void LeapDescent::time_into(PhaseTimes* times) noexcept {
  times_ = times;
  for (std::optional<ContactRows>& rows : rows_)
    if (rows) rows->time_into(times);
}

void LeapDescent::stay_within(const Mat6& onto) {
  onto_ = onto;
  for (std::optional<ContactRows>& rows : rows_)
    if (rows) rows->stay_within(onto);
}

ContactRows& LeapDescent::rows(Guide guide) {
  std::optional<ContactRows>& rows = rows_[static_cast<std::size_t>(guide)];
  if (rows) return *rows;
  if (guide == Guide::outlines)
    rows.emplace(roughly(probe_), roughly(fixed_), method_, few);
  else
    rows.emplace(probe_, fixed_, method_, guide == Guide::few ? few : many);
  rows->time_into(times_);
  if (onto_) rows->stay_within(*onto_);
  return *rows;
}

bool LeapDescent::is_free(const Chart& chart, const Vec6& y) const {
  const PhaseTimer timer(times_, Phase::verify);
  return !overlap(probe_, fixed_, Transform(chart.pose(y)), Doubt::contact);
}

Vec6 LeapDescent::pull_in(const Chart& chart, const Vec6& y, const Deadline& deadline) const {
  double taken = 0, free = 1;
  for (int i = 0; i < leaps.bisections && !deadline.passed(); ++i) {
    const double middle = 0.5 * (taken + free);
    (is_free(chart, middle * y) ? free : taken) = middle;
  }
  return free * y;
}

std::optional<Vec6> LeapDescent::detour(const Chart& chart, const Vec6& first, double margin,
                                        ContactRows& rows, double trust, const Vec6& y,
                                        const Deadline& deadline) {
  Vec6 step = first;
  Effort unlimited;
  for (int round = 0; round < descent_tuning.most_cuts; ++round) {
    if (deadline.passed()) return std::nullopt;
    const auto look = rows.add_cuts(chart, y, Motion(chart, y, y + step), margin, unlimited);
    if (!look.news) {
      // The rows know all obstacles, which bend into the path; or there is no room for more rows.
      limited_ += !look.clear && rows.is_full();
      return std::nullopt;
    }
    step = worth_trying(chart, y, rows.solve(margin, ContactRows::SmallGaps::keep).y - y, trust);
    if (!(-y.dot(step) > leaps.worth * -y.dot(first))) return std::nullopt;
    if (is_free(chart, y + step)) return step;
  }
  ++limited_;
  return std::nullopt;
}

bool LeapDescent::leap(const Chart& chart, const LeastDistance& nearest, double margin,
                       ContactRows& rows, Pace& pace, Vec6& y, const Deadline& deadline) {
  const Vec6 step = worth_trying(chart, y, nearest.y - y, pace.trust);
  const double length = step.norm();
  const auto take = [&](const Vec6& leap) {
    if (deadline.passed() || !is_free(chart, y + leap)) return false;
    y += leap;
    pace.moved = leap.norm();
    return true;
  };
  if (take(step)) {
    pace.trust = leaps.trust_growth * std::max(length, leaps.trust_kept * pace.trust);
    pace.bending *= descent_tuning.bending_decay;
    return true;
  }
  // Leaves room for curved contacts, unless the room costs too much of the gain.
  const double room = std::min(pace.bending * length * length, leaps.most_room * length) + margin;
  const Vec6 lifted =
      worth_trying(chart, y, rows.solve(room, ContactRows::SmallGaps::widen).y - y, pace.trust);
  if (-y.dot(lifted) > leaps.worth * -y.dot(step) && take(lifted)) return true;
  // Rows of obstacles may be missing: the nearest pairs are only a guess of them.
  if (const auto round = pace.complete ? detour(chart, step, margin, rows, pace.trust, y, deadline)
                                       : std::nullopt) {
    y += *round;
    pace.moved = round->norm();
    pace.trust = leaps.trust_after_part * std::max(pace.moved, leaps.trust_kept * pace.trust);
    return true;
  }
  pace.bending *= descent_tuning.bending_growth;
  for (const double part : leaps.parts)
    if (take(part * step)) {
      pace.trust = leaps.trust_after_part * pace.moved;
      return true;
    }
  pace.trust = leaps.trust_lost * length;
  return false;
}

Descent::Outcome LeapDescent::run(const Chart& chart, const Vec6& start, const LeapGoal& goal,
                                  const Deadline& deadline) {
  const double radius = chart.mass().radius;
  ContactRows& rows = this->rows(goal.guide);
  rows.forget();  // the same run gives the same bits, whatever ran before
  Descent::Outcome out;
  out.y = start;
  Pace pace{.trust = goal.reach * start.norm(),
            .bending = descent_tuning.first_bending / radius,
            .complete = goal.guide != Guide::outlines};
  Effort effort = deadline.effort();
  for (;;) {
    const double length = out.y.norm(), allowed = allowed_clearance(radius, length);
    const double margin =
        std::max(leaps.margin_of_tolerance * goal.tolerance * std::min(length, radius),
                 leaps.margin_of_clearance * allowed);
    const double least = leaps.least_reach * margin;
    const double reach =
        std::clamp(leaps.reach * pace.trust, least, leaps.widest_reach * radius + least);
    const double flat = goal.guide == Guide::many ? descent_tuning.flat_within * margin : 0;
    const bool looked = rows.gather(chart, out.y, reach, flat, effort);
    if (!looked && out.iterations == 0) return out;
    if (!looked) rows.move_rows_with_probe(chart, out.y);
    const LeastDistance nearest = rows.solve(margin, ContactRows::SmallGaps::keep);
    // What the rim of the chart holds has not converged.
    const double off = (rows.held_by_contacts(nearest) - out.y).norm();
    out.contacts = rows.holding(nearest);
    out.residual = length > 0 ? off / length : 0;
    if (!looked) return out;
    out.converged = off <= goal.tolerance * length &&
                    rows.smallest_gap() <= descent_tuning.settled_gap * margin;
    const bool hopeless =
        goal.beat > 0 && length > leaps.hopeless * goal.beat && nearest.y.norm() > goal.beat;
    if (out.converged || (hopeless && out.iterations >= leaps.steps_before_hopeless)) return out;
    if (out.iterations >= goal.steps || pace.trust < leaps.least_trust * margin) return out;
    if (deadline.passed()) return out;
    ++out.iterations;
    leap(chart, nearest, margin, rows, pace, out.y, deadline);
  }
}

}  // namespace sonde
