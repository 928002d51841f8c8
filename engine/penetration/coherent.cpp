// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/coherent.hpp"

#include "engine/penetration/descent.hpp"
#include "engine/penetration/result.hpp"
#include "engine/proximity/intersect.hpp"

namespace sonde {

struct CoherentSolver::State {
  std::shared_ptr<const Body> probe, fixed;
  Method method;
  Descent descent;
  Separation last;
  bool started = false;

  State(std::shared_ptr<const Body> a, std::shared_ptr<const Body> b, Method m)
      : probe(std::move(a)), fixed(std::move(b)), method(m), descent(*probe, *fixed, m) {
    last.reason = "not started";
  }
};

CoherentSolver::CoherentSolver(std::shared_ptr<const Body> probe, std::shared_ptr<const Body> fixed,
                               Method method)
    : state_(std::make_unique<State>(std::move(probe), std::move(fixed), method)) {}
CoherentSolver::~CoherentSolver() = default;
CoherentSolver::CoherentSolver(CoherentSolver&&) noexcept = default;
CoherentSolver& CoherentSolver::operator=(CoherentSolver&&) noexcept = default;

const Separation& CoherentSolver::last() const { return state_->last; }

const Separation& CoherentSolver::reset(const Pose& X_FM, const StaticOptions& options) {
  State& s = *state_;
  StaticOptions search = options;
  search.method = s.method;
  search.want_lower_bound = false;
  s.last = separate_static(*s.probe, *s.fixed, X_FM, search);
  s.last.jumped = s.last.status == Status::penetrating;
  s.started = s.last.status != Status::failed;
  return s.last;
}

const Separation& CoherentSolver::tick(const Pose& X_FM, const Budget& budget) noexcept {
  State& s = *state_;
  if (!s.started) {
    s.last = failed(X_FM, "not started");
    return s.last;
  }
  if (!is_finite(X_FM)) {
    // The last separated pose stays what the next tick starts from.
    const Pose kept = s.last.separated;
    s.last = failed(X_FM, "the device pose is not finite");
    s.last.separated = kept;
    return s.last;
  }
  const Deadline deadline{budget.microseconds, budget.microseconds > 0 ? now_us() : 0};
  const Pose device{X_FM.q.normalized(), X_FM.p};
  const Chart chart(s.probe->mass, device);
  const Vec6 y = chart.coordinates(s.last.separated);
  if (s.method == Method::pdt) {
    // Translation only: the separated probe turns with the device where that is free all the way.
    // (Its start is found as a motion of its own: see follow_rotation.)
  }
  DescentGoal goal;
  if (budget.steps > 0) goal.steps = budget.steps;
  const double moved = Chart(s.probe->mass, s.last.device).coordinates(device).norm();
  const Descent::Outcome found = s.descent.run(chart, y, goal, 2 * moved, deadline);
  s.last = make_separation(chart, found);
  return s.last;
}

}  // namespace sonde
