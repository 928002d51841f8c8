// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupler.hpp"

#include <cmath>
#include <numbers>

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
    const Wrench free =
        coupling_.mode == Coupling::Mode::object
            ? object_norm_wrench(mass_, separation.device, separation.separated, coupling_.k)
            : classic(now, separation.jumped ? 0 : dt);
    out = limit(free, coupling_.max_force, coupling_.max_torque);
  }
  motion_ = now;
  has_motion_ = true;
  return out;
}

Wrench Coupler::classic(const SeparationMotion& now, double dt) const noexcept {
  Vec3 t_rate = Vec3::Zero(), theta_rate = Vec3::Zero();
  if (has_motion_ && dt > 0 && std::isfinite(dt)) {
    t_rate = (now.t - motion_.t) / dt;
    // Past half a turn the rotation vector starts again from the other side: no motion did that.
    const Vec3 turn = now.theta - motion_.theta;
    if (turn.norm() <= std::numbers::pi) theta_rate = turn / dt;
  }
  return classic_wrench(now, t_rate, theta_rate, coupling_);
}

}  // namespace sonde
