// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/refinement.hpp"

#include <algorithm>

namespace sonde {
namespace {

/// A list of pairs pays for many short steps, of which there are few here.
constexpr ContactRows::Finding unlisted{.most_pairs = 512, .most_listed = 0};
/// Of the time: the rest is for coming into contact.
constexpr double share_for_leaps = 0.95;
/// Steps: what has not converged by then (flat parts of hundreds of triangles, where a step costs
/// 1 ms) is no nearer by a thousandth after 60.
constexpr int most_swept = 20;
/// Units of Effort, 0.1 ms or so: what a look and a sweep into contact take, of what is out of time
/// before anything is known of its contacts.
constexpr std::int64_t last_look = 10'000;

}  // namespace

Refinement::Refinement(const Body& probe, const Body& fixed, Method method)
    : descent_(probe, fixed, method, unlisted) {}

Descent::Outcome Refinement::run(const Chart& chart, const Vec6& y, LeapDescent& leaps, int steps,
                                 const Deadline& deadline) {
  const Deadline leaping = deadline.part(share_for_leaps);
  Descent::Outcome out;
  out.move_to(y);  // nothing holds it yet
  int taken = 0;
  // Where there was no time even to look, the contacts of before still hold.
  const auto go_on = [&](const Descent::Outcome& next) {
    if (next.contacts.size > 0 || next.y != out.y) out = next;
  };
  const auto leap = [&](LeapGoal goal) {
    goal.steps = std::min(goal.steps, steps - taken);
    if (goal.steps <= 0 || leaping.passed()) return;
    const Descent::Outcome next = leaps.run(chart, out.y, goal, leaping);
    taken += next.iterations;
    go_on(next);
  };
  leap({.guide = Guide::few, .tolerance = 1e-3, .steps = 20, .reach = 0.05});
  out.converged = false;
  leap({.guide = Guide::many, .tolerance = 1e-4, .steps = 30, .reach = 0.005});
  if (!out.converged) {
    const int left = leaping.passed() ? 0 : std::clamp(steps - taken, 0, most_swept);
    Effort effort = deadline.effort();
    descent_.forget();  // the last place was another
    const Descent::Outcome next =
        descent_.run(chart, out.y, {.steps = left}, 1e-3 * out.y.norm(), effort);
    taken += next.iterations;
    go_on(next);
  }
  if (out.contacts.size == 0 && deadline.passed()) {
    Effort last(last_look, 0);
    descent_.forget();
    go_on(descent_.run(chart, out.y, {.steps = 0}, 1e-3 * out.y.norm(), last));
  }
  out.iterations = std::max(taken, 1);
  return out;
}

}  // namespace sonde
