// SPDX-License-Identifier: GPL-3.0-or-later
// Results of a study that nobody ran, for what is computed from results.
#pragma once

#include <utility>
#include <vector>

#include "engine/study/tuning/tuning_results.hpp"

namespace sonde::test {

inline constexpr auto unstable = HoldFault::unstable;

inline TuningColumn column(double damping, double stable, double good, HoldFault fault) {
  TuningColumn c;
  c.damping = damping;
  c.theory_stable = 0.5 * stable;
  c.theory_passive = 0.25 * stable;
  c.stable = {stable, HoldFault::unstable};
  c.good = {good, fault};
  c.long_hold = {900, false, false};
  HoldReport quiet, wild;
  quiet.stable = true;
  c.runs = {{good, quiet}, {2 * stable, wild}};
  return c;
}

/// Where every stable stiffness is good.
inline TuningColumn column(double damping, double stable) {
  return column(damping, stable, stable, HoldFault::unstable);
}

inline TuningLine line(std::size_t situation, GainAxis axis, std::vector<TuningColumn> columns) {
  return {situation, situation == 0 ? "flat" : "edge", "light", axis, "", 1, std::move(columns)};
}

inline TuningResults results() {
  TuningResults r;
  r.about = "{}";
  r.device = {{"mass", 0.2},          {"inertia", 2e-4},
              {"max_stiffness", 1e5}, {"max_force", 10},
              {"max_torque", 0.2},    {"max_rotational_stiffness", 100},
              {"friction", 0.1},      {"rotational_friction", 0.01},
              {"resolution", 0},      {"rotational_resolution", 0}};
  r.max_force = 10;
  r.max_torque = 0.2;
  r.felt = {{1, 1e-3}, {0.5, 1e-3}};
  return r;
}

/// The same with a flat contact that is stable up to the first of these, and an edge up to the
/// second, where there is one.
inline TuningResults stable_up_to(const std::vector<double>& stiffness) {
  TuningResults r = results();
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    r.lines.push_back(line(i, GainAxis::object, {column(0, stiffness[i])}));
  return r;
}

}  // namespace sonde::test
