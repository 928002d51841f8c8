// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/closed_loop.hpp"

#include "engine/body/body.hpp"

namespace sonde {

ClosedLoop::ClosedLoop(const ClosedLoopSetup& setup)
    : setup_(setup),
      X_DM_{Quat::Identity(), -setup.pair.probe().mass.com},
      loop_(setup.pair, setup.method, setup.coupling),
      device_(setup.device, setup.sample_time) {}

void ClosedLoop::reset(const Pose& X_FM, const StaticOptions& options) {
  device_.reset(X_FM * inverse(X_DM_));
  loop_.reset(X_FM, options);
}

void ClosedLoop::step(const Pose& X_FH, const Wrench& push) noexcept {
  loop_.tick(device_.measured() * X_DM_, setup_.sample_time, setup_.budget);
  device_.step(loop_.wrench(), X_FH * inverse(X_DM_), push);
}

Wrench spring_wrench(const MassProperties& mass, const Separation& s, const Coupling& coupling) {
  if (s.status != Status::penetrating) return {};
  if (coupling.mode == Coupling::Mode::object)
    return object_norm_wrench(mass, s.device, s.separated, coupling.k);
  return classic_wrench(separation_motion(mass, s.device, s.separated), Vec3::Zero(), Vec3::Zero(),
                        coupling);
}

double kinetic_energy(const SimulatedDeviceParameters& device, const HandleState& state) {
  return (device.translation.inertia * state.velocity.squaredNorm() +
          device.rotation.inertia * state.spin.squaredNorm()) /
         2;
}

}  // namespace sonde
