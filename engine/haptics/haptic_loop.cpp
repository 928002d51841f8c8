// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/haptic_loop.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "engine/penetration/coherent.hpp"

namespace sonde {

struct HapticLoop::State {
  std::shared_ptr<const Body> probe;
  CoherentSolver solver;
  Method method;
  Coupling coupling;
  Separation separation;
  Wrench wrench;
  SeparationMotion motion;  ///< of the last tick
  bool has_motion = false;  ///< the next separation may be compared with `motion`

  State(std::shared_ptr<const Body> probe_body, std::shared_ptr<const Body> fixed, Method m,
        const Coupling& c)
      : probe(std::move(probe_body)), solver(probe, std::move(fixed), m), method(m), coupling(c) {}

  void update(double dt) noexcept;
  Wrench classic(const SeparationMotion& now, double dt) const noexcept;
};

/// The wrench of the separation just found; dt = 0 where it cannot be compared with the last one.
void HapticLoop::State::update(double dt) noexcept {
  wrench = Wrench{};
  if (separation.status == Status::failed) {
    has_motion = false;
    return;
  }
  SeparationMotion now;
  if (separation.status == Status::penetrating) {
    now = separation_motion(probe->mass, separation.device, separation.separated);
    const Wrench free =
        coupling.mode == Coupling::Mode::object
            ? object_norm_wrench(probe->mass, separation.device, separation.separated, coupling.k)
            : classic(now, separation.jumped ? 0 : dt);
    wrench = limit(free, coupling.max_force, coupling.max_torque);
  }
  motion = now;
  has_motion = true;
}

Wrench HapticLoop::State::classic(const SeparationMotion& now, double dt) const noexcept {
  Vec3 t_rate = Vec3::Zero(), theta_rate = Vec3::Zero();
  if (has_motion && dt > 0 && std::isfinite(dt)) {
    t_rate = (now.t - motion.t) / dt;
    // Past half a turn the rotation vector starts again from the other side: no motion did that.
    const Vec3 turn = now.theta - motion.theta;
    if (turn.norm() <= std::numbers::pi) theta_rate = turn / dt;
  }
  return classic_wrench(now, t_rate, theta_rate, coupling);
}

HapticLoop::HapticLoop(std::shared_ptr<const Body> probe, std::shared_ptr<const Body> fixed,
                       Method method, const Coupling& coupling)
    : state_(std::make_unique<State>(std::move(probe), std::move(fixed), method, coupling)) {}

HapticLoop::~HapticLoop() = default;
HapticLoop::HapticLoop(HapticLoop&&) noexcept = default;
HapticLoop& HapticLoop::operator=(HapticLoop&&) noexcept = default;

void HapticLoop::reset(const Pose& X_FM, const StaticOptions& options) {
  StaticOptions own = options;
  own.method = state_->method;
  state_->separation = state_->solver.reset(X_FM, own);
  state_->has_motion = false;
  state_->update(0);
  // The next tick may come any time later: the rate over that time would mean nothing.
  state_->has_motion = false;
}

void HapticLoop::set_coupling(const Coupling& coupling) noexcept { state_->coupling = coupling; }

void HapticLoop::tick(const Pose& X_FM, double dt, const Budget& budget) noexcept {
  state_->separation = state_->solver.tick(X_FM, budget);
  state_->update(dt);
}

const Separation& HapticLoop::separation() const { return state_->separation; }
const Wrench& HapticLoop::wrench() const { return state_->wrench; }

}  // namespace sonde
