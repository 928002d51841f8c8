// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/closed_loop.hpp"

#include <cmath>

#include "engine/base/elementary.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/haptics/coupling/object_damper.hpp"

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
  const Vec3 phi = rotation_vector(device_.state().X_WD.q * X_FH.q.conjugate());
  device_.step(loop_.wrench(), X_FH * inverse(X_DM_), push_as_turned(push, phi));
}

Wrench push_as_turned(const Wrench& push, const Vec3& phi) {
  // The inverse of the transpose of the rotation vector's Jacobian.
  constexpr double too_far = 3;  // rad
  const double angle = phi.norm();
  if (angle > too_far) return push;
  const double second = angle < 1e-3
                            ? 1.0 / 12
                            : 1 / (angle * angle) - (1 + elementary::cos(angle)) /
                                                        (2 * angle * elementary::sin(angle));
  const Vec3 across = phi.cross(push.torque);
  return {push.force, push.torque + across / 2 + second * phi.cross(across)};
}

Wrench spring_wrench(const MassProperties& mass, const Separation& s, const Coupling& coupling) {
  if (s.status != Status::penetrating) return {};
  if (in_object_norm(coupling.mode))
    return object_norm_wrench(mass, s.device, s.separated, coupling.k);
  return classic_wrench(separation_motion(mass, s.device, s.separated), Vec3::Zero(), Vec3::Zero(),
                        coupling);
}

std::optional<LastSeparation> last_separation(const MassProperties& mass, const Separation& s) {
  if (s.status == Status::failed) return std::nullopt;
  if (s.status != Status::penetrating) return LastSeparation{{}, s.device};
  return LastSeparation{separation_motion(mass, s.device, s.separated), s.device};
}

Wrench commanded_wrench(const ClosedLoopSetup& setup, const Separation& s,
                        const std::optional<LastSeparation>& before) {
  const MassProperties& mass = setup.pair.probe().mass;
  const Coupling& coupling = setup.coupling;
  const double T = setup.sample_time;
  Wrench out = spring_wrench(mass, s, coupling);
  const bool damps = coupling.mode == Coupling::Mode::damped ? !s.fell() : !s.jumped;
  if (coupling.mode == Coupling::Mode::object || !before || !damps) return out;
  if (s.status != Status::penetrating) return out;
  if (coupling.mode == Coupling::Mode::damped) {
    const Wrench damper = object_damper(mass, setup.method, s, before->device, T, coupling);
    out.force += damper.force;
    out.torque += damper.torque;
    return out;
  }
  const SeparationMotion now = separation_motion(mass, s.device, s.separated);
  return classic_wrench(now, (now.t - before->motion.t) / T, (now.theta - before->motion.theta) / T,
                        coupling);
}

double kinetic_energy(const SimulatedDeviceParameters& device, const HandleState& state) {
  return (device.translation.inertia * state.velocity.squaredNorm() +
          device.rotation.inertia * state.spin.squaredNorm()) /
         2;
}

}  // namespace sonde
