// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace sonde {
namespace {

/// |v| of a pose the chart is left at: beyond, ∂w/∂v blows up.
constexpr double largest_v = 0.95;
/// Turn of one step, as |Δv|: a linearised turn is of little use beyond.
constexpr double largest_turn = 0.3;

/// The largest fraction of the step that keeps the turn within bounds.
double turn_limit(const Chart& chart, const Vec6& y, const Vec6& step) {
  const Vec3 dv = chart.v(step), v = chart.v(y);
  double fraction = std::min(1.0, largest_turn / std::max(dv.norm(), 1e-30));
  const double limit = std::max(largest_v, v.norm());
  while (fraction > 1e-6 && (v + fraction * dv).norm() > limit) fraction *= 0.5;
  return fraction;
}

}  // namespace

double allowed_clearance(double radius, double depth) {
  return std::max(1e-9 * radius, 1e-4 * std::min(radius, depth));
}

double now_us() {
  using namespace std::chrono;
  return duration<double, std::micro>(steady_clock::now().time_since_epoch()).count();
}

bool Deadline::passed() const { return microseconds > 0 && now_us() - started > microseconds; }

Descent::Descent(const Body& probe, const Body& fixed, Method method)
    : rows_(probe, fixed, method) {}

void Descent::report(Outcome& out, const Vec6& y, const LeastDistance& nearest) const noexcept {
  out.y = y;
  out.contacts.size = 0;
  for (int i = 0; i < nearest.active_count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!(nearest.multiplier[at] > 0)) continue;
    Contact contact = rows_.contact(nearest.active[at]);
    contact.multiplier = nearest.multiplier[at];
    out.contacts.push(contact);
  }
  const double length = y.norm();
  out.residual = length > 0 ? (y - nearest.y).norm() / length : 0;
}

Descent::Outcome Descent::run(const Chart& chart, const Vec6& start, const DescentGoal& goal,
                              double expected_step, const Deadline& deadline) noexcept {
  const double radius = chart.mass().radius;
  Outcome out;
  Vec6 y = start;
  double scale = expected_step > 0 ? expected_step : 0.05 * radius;
  int stalled = 0;
  Vec6 last_step = Vec6::Zero();
  double longest = std::numeric_limits<double>::max();  // m
  double bending = 0.5 / radius;  // κ, 1/m: what the steps so far have met with
  for (;;) {
    const double length = y.norm();
    const double allowed = allowed_clearance(radius, length);
    const double margin = 0.5 * allowed * goal.clearance;
    const double reach = std::clamp(2 * scale, 16 * margin, std::max(0.03 * radius, 16 * margin));
    rows_.gather(chart, y, reach, 4 * margin);
    out.smallest_gap = rows_.smallest_gap();
    const LeastDistance nearest = rows_.solve(margin, ContactRows::Narrow::keep);
    Vec6 step = nearest.y - y;
    report(out, y, nearest);
    const double size = step.norm();
    if (size <= std::max(goal.residual * length, 0.2 * margin) || !(size > 0)) {
      out.converged = true;
      return out;
    }
    if (out.iterations >= goal.steps || deadline.passed() || stalled >= 4) return out;
    ++out.iterations;

    // The contacts bend into the straight path by about κ|step|²: room for that is left at them,
    // less and less as the steps shorten. More than |step|²/|y| would cost more than the step
    // gains.
    const double affordable = size * size / length;
    const double room = std::min(0.8 * affordable, std::max(bending * size * size, margin));
    if (room > 0.5 * out.smallest_gap) {
      const Vec6 lifted = rows_.solve(room, ContactRows::Narrow::open).y - y;
      if (-y.dot(lifted) > 0.1 * size * size) step = lifted;
    }
    // |y| must fall along all of the path: up to the point of it that is nearest to the origin.
    const double fraction = std::min(1.0, -y.dot(step) / step.squaredNorm());
    step *= std::max(0.0, fraction);
    step *= turn_limit(chart, y, step);
    // Steps that undo each other straddle a sharp edge: halve them until they settle on it.
    if (step.dot(last_step) < -0.25 * step.norm() * last_step.norm())
      longest = 0.5 * std::min(longest, std::min(step.norm(), last_step.norm()));
    else
      longest *= 1.5;
    if (step.norm() > longest) step *= longest / step.norm();
    const double quick = 0.9 * rows_.quick_path(chart, y) - margin;
    const double path = Motion(chart, y, y + step).farthest(radius);
    if (path > quick && quick > 0) step *= quick / path;
    const Vec6 target = y + step;
    const Motion motion(chart, y, target);
    const Sweep swept = rows_.sweep_from(chart, motion, y, 0.5 * margin);
    const double moved = swept.free_until * step.norm();
    last_step = step;
    y = swept.hit ? Vec6(y + swept.free_until * step) : target;
    stalled = moved > 1e-3 * std::max(margin, 1e-3 * size) ? 0 : stalled + 1;
    scale = std::max(moved, 0.1 * scale);
    if (swept.hit && swept.free_until < 0.5)
      bending = std::min(4 * bending, 1e6 / radius);
    else
      bending = std::max(0.5 * bending, 0.1 / radius);
  }
}

}  // namespace sonde
