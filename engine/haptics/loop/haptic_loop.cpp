// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/haptic_loop.hpp"

#include "engine/base/phase_timer.hpp"
#include "engine/body/body.hpp"
#include "engine/haptics/coupling/coupler.hpp"
#include "engine/penetration/search/coherent.hpp"

namespace sonde {

struct HapticLoop::State {
  CoherentSolver solver;
  Method method;
  Coupler coupler;
  Separation separation;
  Wrench wrench;
  bool timed = false;

  State(const Pair& pair, Method m, const Coupling& coupling)
      : solver(pair, m), method(m), coupler(pair.probe().mass, coupling, m) {}
};

HapticLoop::HapticLoop(const Pair& pair, Method method, const Coupling& coupling)
    : state_(std::make_unique<State>(pair, method, coupling)) {}

HapticLoop::~HapticLoop() = default;
HapticLoop::HapticLoop(HapticLoop&&) noexcept = default;
HapticLoop& HapticLoop::operator=(HapticLoop&&) noexcept = default;

void HapticLoop::reset(const Pose& X_FM, const StaticOptions& options) {
  StaticOptions own = options;
  own.method = state_->method;
  state_->separation = state_->solver.reset(X_FM, own);
  state_->coupler.forget();
  state_->wrench = state_->coupler.wrench(state_->separation, 0);
  // The next tick may come much later, so a rate over that time would be meaningless.
  state_->coupler.forget();
}

void HapticLoop::set_coupling(const Coupling& coupling) noexcept {
  state_->coupler.set_coupling(coupling);
}

void HapticLoop::tick(const Pose& X_FM, double dt, const Budget& budget) noexcept {
  state_->separation = state_->solver.tick(X_FM, budget);
  const PhaseTimer timer(state_->timed ? &state_->separation.phases : nullptr, Phase::couple);
  state_->wrench = state_->coupler.wrench(state_->separation, dt);
}

void HapticLoop::time_phases(bool on) noexcept {
  state_->timed = on;
  state_->solver.time_phases(on);
}

const Separation& HapticLoop::separation() const { return state_->separation; }
const Wrench& HapticLoop::wrench() const { return state_->wrench; }

}  // namespace sonde
