// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupling/coupler.hpp"

#include <cmath>
#include <numbers>

#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/haptics/coupling/object_damper.hpp"

namespace sonde {

Wrench Coupler::wrench(const Separation& separation, double dt) noexcept {
  Wrench out;
  if (separation.status == Status::failed) {
    has_motion_ = false;
    return out;
  }
  SeparationMotion now;
  if (separation.status == Status::penetrating) {
    now = separation_motion(mass_, separation.device, separation.separated);
    Wrench free = unlimited(blend_.now, separation, now, dt);
    if (blend_.share < 1) {
      const Wrench before = unlimited(blend_.before, separation, now, dt);
      free.force = before.force + blend_.share * (free.force - before.force);
      free.torque = before.torque + blend_.share * (free.torque - before.torque);
    }
    out = limit(free, blend_.now.max_force, blend_.now.max_torque);
  }
  motion_ = now;
  device_ = separation.device;
  has_motion_ = true;
  return out;
}

Wrench Coupler::unlimited(const Coupling& coupling, const Separation& separation,
                          const SeparationMotion& now, double dt) const noexcept {
  const bool has_rates = has_motion_ && dt > 0 && std::isfinite(dt);
  // What catches up goes faster than the hand: the separation's rate is not the hand's then.
  if (coupling.mode == Coupling::Mode::classic)
    return classic(coupling, now, has_rates && !separation.jumped ? dt : 0);
  Wrench out = object_norm_wrench(mass_, separation.device, separation.separated, coupling.k);
  if (coupling.mode == Coupling::Mode::object || coupling.b_t == 0) return out;
  if (!has_rates || separation.fell()) return out;
  const Wrench damped = object_damper(mass_, method_, separation, device_, dt, coupling);
  out.force += damped.force;
  out.torque += damped.torque;
  return out;
}

Wrench Coupler::classic(const Coupling& coupling, const SeparationMotion& now,
                        double dt) const noexcept {
  Vec3 t_rate = Vec3::Zero(), theta_rate = Vec3::Zero();
  if (dt > 0) {
    t_rate = (now.t - motion_.t) / dt;
    // Beyond half a turn the rotation vector continues on the opposite side; no motion caused that
    // change.
    const Vec3 turn = now.theta - motion_.theta;
    if (turn.norm() <= std::numbers::pi) theta_rate = turn / dt;
  }
  return classic_wrench(now, t_rate, theta_rate, coupling);
}

}  // namespace sonde
