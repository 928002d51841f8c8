// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/comparison/claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/elementary.hpp"
#include "engine/penetration/descent/descent.hpp"

namespace sonde {
namespace {

constexpr double trial_time = 0.25;  // s
constexpr double as_good_as_same = 0.02;

/// The measures of a rendering in one trial.
struct Trial {
  double mean_force = 0;
  double force = 0, torque = 0;  ///< total variation
  double deepest = 0;            ///< m
  bool in_contact = true;
};

Trial trial_of(std::span<const RenderedTick> ticks) {
  Trial out;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const RenderedTick& tick = ticks[i];
    out.in_contact = out.in_contact && !tick.failed && !tick.force.isZero(0);
    out.mean_force += tick.force.norm() / double(ticks.size());
    out.deepest = std::max(out.deepest, tick.depth);
    if (i == 0) continue;
    out.force += (tick.force - ticks[i - 1].force).norm();
    out.torque += (tick.torque - ticks[i - 1].torque).norm();
  }
  return out;
}

std::vector<std::pair<Trial, Trial>> trials(const Comparison& c) {
  const std::size_t ticks = std::min(c.pdt.size(), c.pdg.size());
  std::vector<std::pair<Trial, Trial>> out;
  for (std::size_t from = 0; from < ticks;) {
    std::size_t to = from;
    while (to < ticks && c.pdt[to].t < c.pdt[from].t + trial_time) ++to;
    if (to == ticks) break;  // a shorter interval is no trial
    const auto of = [&](const Rendering& r) {
      return trial_of(std::span(r).subspan(from, to - from));
    };
    const std::pair<Trial, Trial> both{of(c.pdt), of(c.pdg)};
    if (both.first.in_contact && both.second.in_contact) out.push_back(both);
    from = to;
  }
  return out;
}

/// Trials of a claim.
struct Count {
  int for_it = 0, against_it = 0, alike = 0;

  /// By a number of each, of which PD_g's is to be the smaller, or the larger. What differs by no
  /// more than `unresolved` is rounding, or what the solver leaves open.
  void add(double pdt, double pdg, bool larger, double unresolved = 0) {
    if (std::abs(pdt - pdg) <= std::max(as_good_as_same * std::max(pdt, pdg), unresolved))
      ++alike;
    else
      ++((pdg > pdt) == larger ? for_it : against_it);
  }
};

TestedClaim decided(const char* key, const char* claim, const Count& count) {
  const auto [for_it, against_it, alike] = count;
  TestedClaim out{key,        claim, Finding::undecided,           for_it,
                  against_it, alike, sign_test(for_it, against_it)};
  if (for_it + against_it + alike == 0) out.finding = Finding::none;
  if (out.chance < significant)
    out.finding = for_it > against_it ? Finding::supported : Finding::refuted;
  return out;
}

/// N: both ends of a swing may be off by the clearance that the solver may leave, as for a step.
double unresolved_force(const Comparison& c, const Trial& trial) {
  return 2 * c.stiffness * allowed_clearance(c.radius, trial.deepest);
}

/// The claim: PD_g's variation is smaller at equal forces. `arm`: m, of a torque; 1 of a force.
TestedClaim smoother(const Comparison& c, const char* key, const char* claim,
                     double Trial::*variation, double arm) {
  Count count;
  for (const auto& [pdt, pdg] : trials(c))
    count.add(pdt.*variation / pdt.mean_force, pdg.*variation / pdg.mean_force, false,
              arm * (unresolved_force(c, pdt) / pdt.mean_force +
                     unresolved_force(c, pdg) / pdg.mean_force));
  return decided(key, claim, count);
}

/// Pairs of the same tick, by a number of each: PD_g's is to be the smaller, or the larger. Both
/// lists are in the order of ticks.
template <class Tick, class Number>
TestedClaim by_ticks(const std::vector<Tick>& pdt, const std::vector<Tick>& pdg, const char* key,
                     const char* claim, Number Tick::*number, bool larger, double unresolved = 0) {
  Count count;
  for (const Tick& one : pdt) {
    const auto other = std::ranges::lower_bound(pdg, one.tick, {}, &Tick::tick);
    if (other != pdg.end() && other->tick == one.tick)
      count.add(one.*number, (*other).*number, larger, unresolved);
  }
  return decided(key, claim, count);
}

/// Force and torque mostly step in the same tick, which is one trial.
int steps(const MethodMeasures& m) {
  return std::max(m.discontinuities.force_steps, m.discontinuities.torque_steps);
}

}  // namespace

const char* name_of(Finding finding) {
  constexpr std::array names{"supported", "refuted", "undecided", "none"};
  return names[static_cast<std::size_t>(finding)];
}

double sign_test(int one, int other) {
  const int n = one + other, most = std::max(one, other);
  // The first of the sum, of which each is a simple multiple of the last.
  double log_first = -n * elementary::log(2);
  for (int i = 1; i <= n - most; ++i) log_first += elementary::log(double(most + i) / i);
  double term = elementary::exp(log_first), chance = 0;
  for (int k = most; k <= n && term > 0; ++k) {
    chance += term;
    term *= double(n - k) / (k + 1);
  }
  return std::min(1.0, 2 * chance);
}

std::vector<TestedClaim> tested_claims(const Comparison& c) {
  return {
      smoother(c, "smoother_force", "its force is smoother, at equal forces", &Trial::force, 1),
      smoother(c, "smoother_torque", "its torque is smoother, at equal forces", &Trial::torque,
               c.radius),
      decided("fewer_steps", "force and torque have fewer steps",
              {steps(c.of_pdt), steps(c.of_pdg)}),
      decided("fewer_pop_throughs", "it pops through less",
              {c.of_pdt.discontinuities.pop_throughs, c.of_pdg.discontinuities.pop_throughs}),
      by_ticks(c.of_pdt.realism.at_equal_force, c.of_pdg.realism.at_equal_force, "better_torque",
               "its torque is nearer to the analytic one, at equal forces",
               &TorqueRealism::AtTick::error, false,
               std::max(2 * clearance_of_depth, c.of_pdg.realism.facets)),
      by_ticks(c.of_pdt.stiffness.limits, c.of_pdg.stiffness.limits, "more_stable",
               "it is more stable, at equal forces", &StableStiffness::ForceAtLimit::force, true)};
}

}  // namespace sonde
