// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/local_contacts.hpp"

#include <algorithm>
#include <span>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/contact/least_distance.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {
namespace {

/// The least-distance problem of the rows, in the chart of a new device pose.
class LocalProblem {
 public:
  LocalProblem(const Chart& chart, Method method, const LocalContacts& contacts)
      : chart_(chart), method_(method), contacts_(contacts), start_(start()) {}

  struct Solution {
    Vec6 y = Vec6::Zero();
    LeastDistance nearest;
    bool held_back = false;
  };

  Solution solve() noexcept {
    Solution out{.y = start_, .nearest = {}, .held_back = false};
    const double radius = chart_.mass().radius;
    // The rows that are probably active: first those that held the probe in the geometry's answer,
    // then those of the last round.
    std::array<int, 6> likely{0, 1, 2, 3, 4, 5};
    int likely_count = std::min({contacts_.separation.contacts.size, contacts_.size, 6});
    for (int round = 0; round < loop_tuning.most_rounds; ++round) {
      const std::span start(likely.data(), static_cast<std::size_t>(likely_count));
      out.nearest = least_distance(linearise(out.y), loop_tuning.solved_to * radius, start);
      likely = out.nearest.active;
      likely_count = out.nearest.active_count;
      if (!out.nearest.feasible) {
        out.held_back = true;
        break;
      }
      const Vec6 step = (out.nearest.y - out.y) * turn_limit(out.y, out.nearest.y);
      out.y += step;
      // The error of a linearised row grows with about the square of the turn.
      const double bend = chart_.v(step).squaredNorm() * radius;
      if (bend <= loop_tuning.settled_depth * out.y.norm() + loop_tuning.settled_radius * radius)
        break;
    }
    out.held_back |= keep_within_reach(out.y);
    return out;
  }

  /// The contacts that hold the solution.
  ContactSet holding(const Solution& solution) const noexcept {
    ContactSet out;
    const Pose X = chart_.pose(solution.y);
    for (int i = 0; i < solution.nearest.active_count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (!(solution.nearest.multiplier[at] > 0)) continue;
      const LocalContact& row =
          contacts_.rows[static_cast<std::size_t>(solution.nearest.active[at])];
      const Vec3 a = X * row.on_probe;
      out.push({a, row.on_fixed, row.normal, row.normal.dot(a - row.on_fixed),
                solution.nearest.multiplier[at]});
    }
    return out;
  }

 private:
  /// The separated pose of the geometry; with translation only, turned with the device.
  Vec6 start() const {
    Vec6 y = chart_.coordinates(contacts_.separation.separated);
    if (method_ == Method::pdt) y.head<3>().setZero();
    return y;
  }

  std::span<const HalfSpace> linearise(const Vec6& y) noexcept {
    const Transform X(chart_.pose(y));
    const auto count = static_cast<std::size_t>(contacts_.size);
    for (std::size_t i = 0; i < count; ++i) {
      const LocalContact& row = contacts_.rows[i];
      const Vec3 a = X * row.on_probe;
      HalfSpace& half_space = half_spaces_[i];
      half_space.normal = chart_.row(y, a, row.normal);
      if (method_ == Method::pdt) half_space.normal.head<3>().setZero();
      const double room = row.normal.dot(a - row.on_fixed) - row.least_gap;
      half_space.bound = half_space.normal.dot(y) - room;
    }
    return {half_spaces_.data(), count};
  }

  double turn_limit(const Vec6& from, const Vec6& to) const {
    const Vec3 v = chart_.v(from), dv = chart_.v(to) - v;
    const double limit = std::max(Chart::largest_v, v.norm());
    double fraction = 1;
    while (fraction > loop_tuning.least_part && (v + fraction * dv).norm() > limit) fraction *= 0.5;
    return fraction;
  }

  bool keep_within_reach(Vec6& y) const {
    const double path = Motion(chart_, start_, y).farthest(chart_.mass().radius);
    const double trusted = std::max(contacts_.reach, loop_tuning.trusted * chart_.mass().radius);
    if (path <= trusted) return false;
    y = start_ + (trusted / path) * (y - start_);
    return true;
  }

  const Chart& chart_;
  Method method_;
  const LocalContacts& contacts_;
  Vec6 start_;
  std::array<HalfSpace, LocalContacts::capacity> half_spaces_;
};

/// See LocalAnswer::lag.
double lag(const Chart& chart, Method method, const LocalContacts& contacts,
           const LocalProblem::Solution& solution) {
  const Separation& known = contacts.separation;
  const bool without_rows = contacts.size == 0 && known.status == Status::penetrating;
  if (!solution.nearest.feasible || without_rows) return known.residual * known.depth;
  const double behind = (solution.y - solution.nearest.y).norm();
  if (method == Method::pdg) return behind;
  return behind + chart.coordinates(known.separated).head<3>().norm();
}

}  // namespace

LocalAnswer separate_locally(const MassProperties& mass, Method method,
                             const LocalContacts& contacts, const Pose& X_FM) noexcept {
  if (const char* fault = fault_of(X_FM)) return {failed(X_FM, fault), false};
  const Separation& known = contacts.separation;
  const Pose device{X_FM.q.normalized(), X_FM.p};
  if (known.status == Status::failed) return {failed(device, known.reason), false};
  Chart chart(mass, device);
  chart.absorb_free_spin(known.separated);
  LocalProblem problem(chart, method, contacts);
  const LocalProblem::Solution solution = problem.solve();
  Descent::Outcome found;
  found.y = solution.y;
  found.contacts = problem.holding(solution);
  found.iterations = known.iterations;
  found.converged = known.converged;
  const double length = solution.y.norm();
  found.residual = length > 0 ? (solution.y - solution.nearest.y).norm() / length : 0;
  return {make_separation(chart, found), solution.held_back,
          lag(chart, method, contacts, solution)};
}

}  // namespace sonde
