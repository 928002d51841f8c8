// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/verified.hpp"

#include "engine/base/phase_timer.hpp"
#include "engine/penetration/descent/refinement_tuning.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/proximity/queries/intersect.hpp"

namespace sonde {

Verified::Verified(const Pair& pair, const Chart& chart, PhaseTimes* times)
    : probe_(pair.probe()), fixed_(pair.fixed()), chart_(chart), times_(times) {}

Separation Verified::refined(Method method, const Vec6& y, LeapDescent& leaps, int steps,
                             const Deadline& deadline) {
  std::optional<Refinement>& refinement = refinements_[method == Method::pdg ? 0 : 1];
  if (!refinement) refinement.emplace(probe_, fixed_, method).time_into(times_);
  return make_separation(chart_, refinement->run(chart_, y, leaps, steps, deadline));
}

void Verified::add(const Separation& answer) {
  if (best_ && best_->depth <= answer.depth) {
    // A descent that ran to its end beside the best, and is no less deep, shows that no steps were
    // missing there.
    best_->converged = best_->converged || (answer.converged && is_beside_best(answer));
    return;
  }
  if (is_free(answer)) best_ = answer;
}

bool Verified::is_beside_best(const Separation& answer) const {
  const Vec6 apart = chart_.coordinates(answer.separated) - chart_.coordinates(best_->separated);
  return apart.norm() <= refinement_tuning.second.reach * best_->depth &&
         answer.depth <= (1 + refinement_tuning.second.tolerance) * best_->depth;
}

bool Verified::is_free(const Separation& answer) const {
  const PhaseTimer timer(times_, Phase::verify);
  return !overlap(probe_, fixed_, Transform(answer.separated), Doubt::exact);
}

}  // namespace sonde
