// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/leap_descent.hpp"

#include <algorithm>
#include <cmath>

#include "engine/proximity/intersect.hpp"

namespace sonde {
namespace {

/// So few of the nearest pairs tell where to go; more of them would tell it no better.
constexpr ContactRows::Finding few{.most_pairs = 96, .most_listed = 0};

/// A turn of more than this, as |Δv|, is beyond what linearised contacts can say anything about.
constexpr double largest_turn = 0.3;
constexpr double largest_v = 0.95;

/// The part of a step that is worth trying first: |y| falls along all of it, the turn is within
/// bounds, and it is no longer than trusted.
Vec6 worth_trying(const Chart& chart, const Vec6& y, Vec6 step, double trust) {
  step *= std::clamp(-y.dot(step) / step.squaredNorm(), 0.0, 1.0);
  const double turn = chart.v(step).norm(), length = step.norm();
  step *= std::min({1.0, largest_turn / std::max(turn, 1e-30), trust / std::max(length, 1e-300)});
  const double limit = std::max(largest_v, chart.v(y).norm());
  while (chart.v(y + step).norm() > limit) step *= 0.5;
  return step;
}

}  // namespace

LeapDescent::LeapDescent(const Body& probe, const Body& fixed, Method method)
    : probe_(probe),
      fixed_(fixed),
      rough_(sonde::roughly(probe), sonde::roughly(fixed), method, few),
      exact_(probe, fixed, method, few) {}

bool LeapDescent::is_free(const Chart& chart, const Vec6& y) const {
  return !overlap(probe_, fixed_, Transform(chart.pose(y)), Doubt::contact);
}

Vec6 LeapDescent::pull_in(const Chart& chart, const Vec6& y) const {
  double taken = 0, free = 1;
  for (int i = 0; i < 7; ++i) {
    const double middle = 0.5 * (taken + free);
    (is_free(chart, middle * y) ? free : taken) = middle;
  }
  return free * y;
}

LeapDescent::Outcome LeapDescent::run(const Chart& chart, const Vec6& start, const LeapGoal& goal,
                                      const Deadline& deadline) {
  const double radius = chart.mass().radius;
  ContactRows& rows = this->rows(goal.roughly);
  rows.forget();  // the same run gives the same bits, whatever was run before
  Outcome out;
  out.y = start;
  double trust = goal.reach * start.norm();
  while (out.iterations < goal.steps && !deadline.passed()) {
    const double length = out.y.norm();
    const double margin =
        std::max(0.1 * goal.tolerance * length, 0.5 * allowed_clearance(radius, length));
    rows.gather(chart, out.y, std::clamp(0.5 * trust, 4 * margin, 0.1 * radius + 4 * margin), 0);
    const LeastDistance nearest = rows.solve(margin, ContactRows::Narrow::keep);
    const Vec6 whole = nearest.y - out.y;
    out.converged = whole.norm() <= goal.tolerance * length;
    if (out.converged) break;
    const bool hopeless = goal.beat > 0 && length > 1.1 * goal.beat && nearest.y.norm() > goal.beat;
    if (hopeless && out.iterations >= 3) break;
    ++out.iterations;
    const Vec6 step = worth_trying(chart, out.y, whole, trust);
    double part = 1;
    int tries = 0;
    while (tries < 3 && !is_free(chart, out.y + part * step)) part *= 0.4, ++tries;
    const double moved = part * step.norm();
    if (tries < 3) out.y += part * step, out.last_step = moved;
    trust = tries == 0 ? 2 * std::max(moved, 0.5 * trust) : tries < 3 ? 1.2 * moved : 1.5 * moved;
    if (trust < 0.2 * margin) break;
  }
  return out;
}

}  // namespace sonde
