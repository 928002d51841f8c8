// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/refinement.hpp"

#include <algorithm>

#include "engine/penetration/descent/leap_tuning.hpp"
#include "engine/penetration/descent/refinement_tuning.hpp"

namespace sonde {
namespace {

/// For the swept descent: as many pairs as the last leaps have, and no neighbour list, which would
/// pay only for many short steps; here there are few.
constexpr ContactRows::Finding unlisted{.most_pairs = leap_tuning.many_pairs, .keeps_lists = false};

}  // namespace

Refinement::Refinement(const Body& probe, const Body& fixed, Method method)
    : descent_(probe, fixed, method, unlisted) {}

Descent::Outcome Refinement::run(const Chart& chart, const Vec6& y, LeapDescent& leaps, int steps,
                                 const Deadline& deadline) {
  const Deadline leaping = deadline.part(refinement_tuning.share_for_leaps);
  Descent::Outcome out;
  out.move_to(y);  // no contact holds it yet
  int taken = 0;
  // If there was no time for a gather, the earlier contacts remain valid.
  const auto go_on = [&](const Descent::Outcome& next) {
    if (next.contacts.size > 0 || next.y != out.y) out = next;
  };
  const auto leap = [&](Guide guide, const RefinementTuning::Leaps& by) {
    const LeapGoal goal{.guide = guide,
                        .tolerance = by.tolerance,
                        .steps = std::min(by.steps, steps - taken),
                        .reach = by.reach};
    if (goal.steps <= 0 || leaping.passed()) return;
    const Descent::Outcome next = leaps.run(chart, out.y, goal, leaping);
    taken += next.iterations;
    go_on(next);
  };
  leap(Guide::few, refinement_tuning.first);
  out.converged = false;
  leap(Guide::many, refinement_tuning.second);
  if (!out.converged) {
    const int left =
        leaping.passed() ? 0 : std::clamp(steps - taken, 0, refinement_tuning.most_swept);
    Effort effort = deadline.effort();
    descent_.forget();  // the last run was at another place
    const Descent::Outcome next = descent_.run(
        chart, out.y, {.steps = left}, refinement_tuning.expected_step * out.y.norm(), effort);
    taken += next.iterations;
    go_on(next);
  }
  if (out.contacts.size == 0 && deadline.passed()) {
    // The nearer the probe is to its contacts, the fewer pairs there are to examine.
    out.move_to(leaps.pull_in(chart, out.y, {refinement_tuning.us_of_last_pull, now_us()}));
    Effort last(refinement_tuning.last_look, 0);
    descent_.forget();
    go_on(descent_.run(chart, out.y, {.steps = 0},
                       refinement_tuning.expected_after_pull * out.y.norm(), last));
  }
  out.iterations = std::max(taken, 1);
  return out;
}

}  // namespace sonde
