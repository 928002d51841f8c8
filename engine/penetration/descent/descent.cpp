// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/descent.hpp"

#include <algorithm>
#include <cmath>

#include "engine/penetration/descent/chart_rim.hpp"
#include "engine/penetration/descent/descent_tuning.hpp"
#include "engine/penetration/descent/pace.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {

double allowed_clearance(double radius, double depth) {
  return std::max(1e-9 * radius, clearance_of_depth * std::min(radius, depth));
}

Descent::Descent(const Body& probe, const Body& fixed, Method method,
                 const ContactRows::Finding& finding, double gap)
    : rows_(probe, fixed, method, finding), gap_(gap), extents_(extent(probe) + extent(fixed)) {}

void Descent::forget() noexcept {
  rows_.forget();
  path_length_.forget();
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

Vec6 Descent::next_step(const Chart& chart, const Vec6& y, const LeastDistance& nearest,
                        double margin, double rise, const Pace& pace) noexcept {
  Vec6 step = nearest.y - y;
  const double size2 = step.squaredNorm();
  // The contacts bend into the straight path by about κ|step|². The step leaves that much room at
  // them, less and less as the steps shorten. More than |step|²/|y| would cost more than the step
  // gains.
  const double room =
      std::min(descent_tuning.most_room * size2 / y.norm(), std::max(pace.bending * size2, margin));
  const bool crowded = rows_.smallest_gap() < descent_tuning.crowded_gap * margin;
  const double lift = descent_tuning.most_lift * margin;
  bool lifts = false;
  const auto gains = [&](const Vec6& way) {
    return -y.dot(way) > descent_tuning.least_gain * size2;
  };
  // If this room costs too much of the gain, the step leaves a part of it. A probe that is too near
  // its contacts for any straight step moves away from them again, even at the price of some depth.
  for (double part = crowded ? std::max(room, margin) : room; part > 0.5 * rows_.smallest_gap();) {
    const LeastDistance up = rows_.solve(part, ContactRows::SmallGaps::widen);
    const bool regains = crowded && up.feasible && part <= margin;
    if (gains(up.y - y) || (regains && part > 2 * rows_.smallest_gap() &&
                            up.y.norm() <= std::min(y.norm() + lift, pace.ceiling))) {
      step = up.y - y;
      lifts = regains;
      break;
    }
    const double less = descent_tuning.less_room * part;
    part = crowded && less < margin && part > margin ? margin : less;
  }
  if (rise > 0) {
    const Vec6 risen = rows_.solve(margin, ContactRows::SmallGaps::keep, rise).y - y;
    if (gains(risen)) step = risen, lifts = false;
  }
  step = within_chart(chart, y, step);
  // At the rim of the chart, the step may vanish.
  if (!(step.squaredNorm() > 0)) return Vec6::Zero();
  // |y| decreases along the whole path, which ends at its point nearest to the origin.
  if (!lifts) step *= std::clamp(-y.dot(step) / step.squaredNorm(), 0.0, 1.0);
  step = shortened(step, pace.longest);
  return std::min(1.0, most_of_path(chart, y, step, margin, pace)) * step;
}

double Descent::most_of_path(const Chart& chart, const Vec6& y, const Vec6& step, double margin,
                             const Pace& pace) const noexcept {
  const double quick =
      std::max(std::min(path_length_.longest(), pace.longest), descent_tuning.least_path * margin);
  return quick / Motion(chart, y, y + step).farthest(chart.mass().radius);
}

double Descent::margin(const Chart& chart, double depth) const noexcept {
  const double rounding = rounding_guard(extents_, depth, chart.device().p);
  return std::max(gap_ * allowed_clearance(chart.mass().radius, depth), 16 * rounding);
}

Sweep Descent::sweep_to(const Chart& chart, const Vec6& y, const Vec6& target,
                        Effort& effort) noexcept {
  return rows_.sweep_along(Motion(chart, y, target), 0.5 * margin(chart, y.norm()), effort);
}

Sweep Descent::short_sweep_to(const Chart& chart, const Vec6& y, const Vec6& target,
                              Effort& effort) noexcept {
  // No path is shorter than the least one, so that one may take what the tick has: else the probe
  // would stay where it is for ever.
  const double least = descent_tuning.least_path * margin(chart, y.norm());
  if (Motion(chart, y, target).farthest(chart.mass().radius) < 1.01 * least)
    return sweep_to(chart, y, target, effort);
  return effort.at_most(descent_tuning.most_work_of_sweep,
                        [&](Effort& part) { return sweep_to(chart, y, target, part); });
}

std::optional<Vec6> Descent::turned_by_rows(const Chart& chart, const Vec6& y) noexcept {
  if (!rows_.reuse_rows(chart, y)) return std::nullopt;
  // Slightly above the contacts, since they bend into the path.
  const LeastDistance rest =
      rows_.solve(1.2 * margin(chart, y.norm()), ContactRows::SmallGaps::widen);
  if (!rest.feasible) return std::nullopt;
  return rest.y;
}

void Descent::approach_contact(const Chart& chart, double margin, Effort& effort,
                               Outcome& out) noexcept {
  // Sweeps in pieces: for one long sweep with a large turn, the bound of the path's curvature is
  // too loose.
  const auto pieces = static_cast<int>(1 + chart.v(out.y).norm() / descent_tuning.largest_turn);
  const Vec6 piece = out.y / pieces;
  Vec6 near = out.y;
  Sweep swept;
  for (int left = pieces; left > 0 && !swept.hit; --left) {
    const Vec6 next = left > 1 ? Vec6(near - piece) : Vec6::Zero();
    swept = short_sweep_to(chart, near, next, effort);
    near = swept.hit ? Vec6(near + swept.free_until * (next - near)) : next;
  }
  out.move_to(near);
  if (!rows_.gather(chart, near, descent_tuning.least_reach * margin,
                    descent_tuning.flat_within * margin, effort))
    return;
  report(out, near, rows_.solve(margin, ContactRows::SmallGaps::keep));
}

}  // namespace sonde
