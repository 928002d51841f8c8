// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/penetration/descent/descent_tuning.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

/// What a step takes besides what is counted where it is done, in the units of Effort.
constexpr int work_of_step = 500;

/// The part of the way from one turn to another, both as v, after which it is as large as `limit`.
double part_to_rim(const Vec3& from, const Vec3& to, double limit) {
  const Vec3 along = to - from;
  const double a = along.squaredNorm(), b = from.dot(along);
  const double c = from.squaredNorm() - limit * limit;
  return a > 0 ? (std::sqrt(std::max(0.0, b * b - a * c)) - b) / a : 0;
}

/// The step with its turn kept within bounds. Where it would lead out of the chart it ends at the
/// rim, which is a row there. From the rim itself it goes along it, to what lies there on the way
/// from O to its end; other rows may not hold on that way.
Vec6 within_chart(const Chart& chart, const Vec6& y, const Vec6& step) {
  const double turn = chart.v(step).norm();
  Vec6 bounded = std::min(1.0, descent_tuning.largest_turn / std::max(turn, 1e-30)) * step;
  Vec6 target = y + bounded;
  const Vec3 from = chart.v(y), to = chart.v(target);
  const double limit = std::max(Chart::largest_v, from.norm());
  if (to.norm() <= limit) return bounded;
  const double part = part_to_rim(from, to, limit);
  if (part > descent_tuning.least_way_to_rim) return part * bounded;
  target.head<3>() *= limit / to.norm();
  return target - y;
}

bool at_rim(const Chart& chart, const Vec6& y) {
  return chart.v(y).norm() > (1 - 1e-6) * Chart::largest_v;
}

Vec6 shortened(const Vec6& step, double longest) {
  const double size = step.norm();
  return size > longest ? Vec6(step * (longest / size)) : step;
}

}  // namespace

double allowed_clearance(double radius, double depth) {
  return std::max(1e-9 * radius, 1e-4 * std::min(radius, depth));
}

Descent::Descent(const Body& probe, const Body& fixed, Method method,
                 const ContactRows::Finding& finding, double gap)
    : rows_(probe, fixed, method, finding),
      gap_(gap),
      extents_(extent(probe) + extent(fixed)),
      longest_path_(std::numeric_limits<double>::infinity()) {}

void Descent::forget() noexcept {
  rows_.forget();
  longest_path_ = std::numeric_limits<double>::infinity();
}

void Descent::Outcome::move_to(const Vec6& to) noexcept {
  y = to;
  const double length = y.norm();
  residual = length > 0 ? (y - held).norm() / length : 0;
}

void Descent::report(Outcome& out, const Vec6& y, const LeastDistance& nearest) const noexcept {
  out.contacts = rows_.holding(nearest);
  out.held = rows_.held_by_contacts(nearest);
  out.move_to(y);
}

/// What the steps so far say about the next.
struct Descent::Pace {
  double scale;    ///< m: about how long a step is
  double bending;  ///< κ, 1/m: how much contacts have been met to bend into the path
  /// m: no further is a step looked at, since long paths cost much to sweep.
  double longest = std::numeric_limits<double>::max();
  /// m: no further does it go. What is in the way of a step is looked for up to where it would go
  /// undamped: rows that are missing, at whose place others let it go to and fro, are there.
  double damped_to = std::numeric_limits<double>::max();
  Vec6 last = Vec6::Zero();
  int stalled = 0;  ///< steps in a row that led nowhere

  /// Steps that undo each other straddle a sharp edge: they are halved until they settle on it.
  Vec6 damped(const Vec6& step) {
    const double size = step.norm();
    if (step.dot(last) < descent_tuning.turns_back * size * last.norm())
      damped_to = 0.5 * std::min({damped_to, size, last.norm()});
    else
      damped_to *= descent_tuning.longest_growth;
    return shortened(step, damped_to);
  }
  void learn(const Vec6& step, const Sweep& swept, double worth_while, double radius) {
    const double moved = swept.free_until * step.norm();
    last = step;
    stalled = moved > worth_while ? 0 : stalled + 1;
    scale = std::max(moved, 0.1 * scale);
    const bool cut_short = swept.hit && !swept.given_up && swept.free_until < 0.5;
    bending = cut_short ? std::min(descent_tuning.bending_growth * bending,
                                   descent_tuning.most_bending / radius)
                        : std::max(descent_tuning.bending_decay * bending,
                                   descent_tuning.least_bending / radius);
  }
};

Vec6 Descent::next_step(const Chart& chart, const Vec6& y, const LeastDistance& nearest,
                        double margin, double rise, const Pace& pace) noexcept {
  const double radius = chart.mass().radius;
  Vec6 step = nearest.y - y;
  const double size2 = step.squaredNorm();
  // The contacts bend into the straight path by about κ|step|²: room for that is left at them, less
  // and less as the steps shorten. More than |step|²/|y| would cost more than the step gains.
  const double room =
      std::min(descent_tuning.most_room * size2 / y.norm(), std::max(pace.bending * size2, margin));
  // Where so much is not to be had, a part of it is: what has come too near its contacts for a
  // straight step to lead anywhere gets away from them again.
  for (double part = room; part > 0.5 * rows_.smallest_gap(); part *= descent_tuning.less_room) {
    const Vec6 lifted = rows_.solve(part, ContactRows::SmallGaps::widen).y - y;
    if (!(-y.dot(lifted) > descent_tuning.least_gain * size2)) continue;
    step = lifted;
    break;
  }
  if (rise > 0) {
    const Vec6 risen = rows_.solve(margin, ContactRows::SmallGaps::keep, rise).y - y;
    if (-y.dot(risen) > descent_tuning.least_gain * size2) step = risen;
  }
  step = within_chart(chart, y, step);
  // At the rim of the chart nothing may be left of it.
  if (!(step.squaredNorm() > 0)) return Vec6::Zero();
  // |y| must fall along all of the path: up to the point of it that is nearest to the origin.
  step *= std::clamp(-y.dot(step) / step.squaredNorm(), 0.0, 1.0);
  step = shortened(step, pace.longest);
  const double quick = std::max(longest_path_, 8 * margin);
  const double path = Motion(chart, y, y + step).farthest(radius);
  return path > quick ? Vec6(step * (quick / path)) : step;
}

double Descent::margin(const Chart& chart, double depth) const noexcept {
  const double rounding = rounding_guard(extents_, depth, chart.device().p);
  return std::max(gap_ * allowed_clearance(chart.mass().radius, depth), 16 * rounding);
}

Sweep Descent::sweep_to(const Chart& chart, const Vec6& y, const Vec6& target,
                        Effort& effort) noexcept {
  return rows_.sweep_along(Motion(chart, y, target), 0.5 * margin(chart, y.norm()), effort);
}

std::optional<Vec6> Descent::turned_by_rows(const Chart& chart, const Vec6& y) noexcept {
  if (!rows_.reuse_rows(chart, y)) return std::nullopt;
  // A little above the contacts, since they bend.
  const LeastDistance rest =
      rows_.solve(1.2 * margin(chart, y.norm()), ContactRows::SmallGaps::widen);
  if (!rest.feasible) return std::nullopt;
  return rest.y;
}

void Descent::approach_contact(const Chart& chart, double margin, Effort& effort,
                               Outcome& out) noexcept {
  // In pieces: how a path with a large turn bends is known too loosely for one long sweep.
  const auto pieces = static_cast<int>(1 + chart.v(out.y).norm() / descent_tuning.largest_turn);
  const Vec6 piece = out.y / pieces;
  Vec6 near = out.y;
  Sweep swept;
  for (int left = pieces; left > 0 && !swept.hit; --left) {
    const Vec6 next = left > 1 ? Vec6(near - piece) : Vec6::Zero();
    swept = sweep_to(chart, near, next, effort);
    near = swept.hit ? Vec6(near + swept.free_until * (next - near)) : next;
  }
  out.move_to(near);
  if (!rows_.gather(chart, near, descent_tuning.least_reach * margin,
                    descent_tuning.flat_within * margin, effort))
    return;
  report(out, near, rows_.solve(margin, ContactRows::SmallGaps::keep));
}

Descent::Outcome Descent::run(const Chart& chart, const Vec6& start, const DescentGoal& goal,
                              double expected_step, const Deadline& deadline) noexcept {
  Effort unlimited;
  return run(chart, start, goal, expected_step, deadline, unlimited);
}

Descent::Outcome Descent::run(const Chart& chart, const Vec6& start, const DescentGoal& goal,
                              double expected_step, Effort& effort) noexcept {
  return run(chart, start, goal, expected_step, {}, effort);
}

Descent::Outcome Descent::run(const Chart& chart, const Vec6& start, const DescentGoal& goal,
                              double expected_step, const Deadline& deadline,
                              Effort& effort) noexcept {
  const double radius = chart.mass().radius;
  Outcome out;
  Vec6 y = start;
  Pace pace{.scale = expected_step > 0 ? expected_step : descent_tuning.first_scale * radius,
            .bending = descent_tuning.first_bending / radius};
  if (expected_step > 0)
    pace.longest = std::max(descent_tuning.longest_per_expected * expected_step,
                            descent_tuning.first_longest * radius);
  // Where the last run ended its rows still hold, and tell the way: most ticks go on from there.
  bool known = rows_.reuse_rows(chart, y);
  for (;;) {
    const double length = y.norm();
    const double margin = this->margin(chart, length);
    const double nearest_reach = descent_tuning.least_reach * margin;
    const double widest = std::max(descent_tuning.widest_reach * radius, nearest_reach);
    out.move_to(y);
    const double reach = std::clamp(
        (out.iterations == 0 ? descent_tuning.reach_at_first : descent_tuning.reach_later) *
            pace.scale,
        nearest_reach, widest);
    if (!known && !rows_.gather(chart, y, reach, descent_tuning.flat_within * margin, effort)) {
      if (out.iterations > 0) return out;
      rows_.halve_next_reach(descent_tuning.flat_within * margin);
      rows_.move_rows_with_probe(chart, y);
      report(out, y, rows_.solve(margin, ContactRows::SmallGaps::keep));
      return out;
    }
    known = false;
    LeastDistance nearest = rows_.solve(margin, ContactRows::SmallGaps::keep);
    report(out, y, nearest);
    const double size = (nearest.y - y).norm();
    const auto settled = [&] {
      // Not what the rim of the chart holds: there the descent only ends.
      const double off = (out.held - y).norm();
      // Where no row holds it the probe can come all the way back, however little that is.
      const bool held = out.contacts.size > 0;
      return (held &&
              off <= std::max(goal.residual * length, descent_tuning.off_in_margins * margin) &&
              rows_.smallest_gap() <= descent_tuning.settled_gap * margin) ||
             !(off > 0);
    };
    out.converged = settled();
    // One step at least, however late: a tick that never moves would never catch up.
    const bool late = out.iterations > 0 && deadline.passed();
    if (out.converged) return out;
    const bool stalled = pace.stalled >= descent_tuning.most_stalled;
    if (late || stalled || out.iterations >= goal.steps) {
      out.limited += stalled || at_rim(chart, y);
      if (rows_.smallest_gap() > descent_tuning.touching_gap * margin)
        approach_contact(chart, margin, effort, out);
      return out;
    }
    ++out.iterations;
    effort.spend(work_of_step);
    pace.longest *= descent_tuning.longest_growth;
    double rise = 0;
    Vec6 step = next_step(chart, y, nearest, margin, rise, pace);
    for (int round = 0;; ++round) {
      if (round == descent_tuning.most_cuts) {
        ++out.limited;
        break;
      }
      const ContactRows::PathCheck look =
          rows_.cut(chart, y, Motion(chart, y, y + step), margin, effort);
      if (look.clear || effort.is_spent()) break;
      if (look.news) {
        nearest = rows_.solve(margin, ContactRows::SmallGaps::keep);
        report(out, y, nearest);
        out.converged = settled();
        if (out.converged) return out;
      }
      out.limited += !look.news && rows_.is_full();
      // Contacts that the rows know bend into the path by so much.
      rise = look.news ? 0 : rise + descent_tuning.rise_per_loss * look.lost;
      step = next_step(chart, y, nearest, margin, rise, pace);
    }
    if (!(step.squaredNorm() > 0)) {
      out.limited += at_rim(chart, y);
      return out;
    }
    step = pace.damped(step);
    const Vec6 target = y + step;
    const Sweep swept = sweep_to(chart, y, target, effort);
    if (!swept.given_up)
      longest_path_ *= 2;
    else if (out.iterations == 1)
      longest_path_ =
          descent_tuning.longest_after_giving_up * Motion(chart, y, target).farthest(radius);
    y = swept.hit ? Vec6(y + swept.free_until * step) : target;
    pace.learn(step, swept, descent_tuning.nowhere * std::max(margin, 1e-3 * size), radius);
  }
}

}  // namespace sonde
