// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/axis_map.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/elementary.hpp"
#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

double without_dead_zone(double deflection, double dead_zone) {
  const double beyond = std::abs(deflection) - dead_zone;
  return beyond <= 0 ? 0 : std::copysign(beyond / (1 - dead_zone), deflection);
}

double curved(double deflection, double expo) {
  return (1 - expo) * deflection + expo * deflection * deflection * deflection;
}

Pose moved(const Pose& X_FP, const SixAxes& by, const Reach& reach) {
  return {(rotation_by(reach.rotation * by.tail<3>()) * X_FP.q).normalized(),
          X_FP.p + reach.translation * by.head<3>()};
}

}  // namespace

SixAxes mapped(const AxisMap& map, const SixAxes& deflection) noexcept {
  SixAxes result = SixAxes::Zero();
  for (std::size_t i = 0; i < 6; ++i) {
    const AxisSetting& axis = map.axes[i];
    if (axis.source < 0 || axis.source > 5) continue;
    const double value = std::clamp(deflection[axis.source], -1.0, 1.0);
    const double sign = axis.inverted ? -1 : 1;
    result[static_cast<Eigen::Index>(i)] =
        sign * axis.gain * curved(without_dead_zone(value, axis.dead_zone), axis.expo);
  }
  return result;
}

Pose position_controlled(const Pose& X_FP_rest, const SixAxes& mapped,
                         const Reach& reach) noexcept {
  return moved(X_FP_rest, mapped, reach);
}

Pose position_at_rest(const Pose& X_FP, const SixAxes& mapped, const Reach& reach) noexcept {
  return moved(X_FP, -mapped, reach);
}

Pose rate_controlled(const Pose& X_FP, const SixAxes& mapped, const Reach& rate,
                     double dt) noexcept {
  return moved(X_FP, mapped, {rate.translation * dt, rate.rotation * dt});
}

SixAxes smoothed(const SixAxes& last, const SixAxes& target, double dt,
                 double time_constant) noexcept {
  if (time_constant <= 0) return target;
  return target + elementary::exp(-dt / time_constant) * (last - target);
}

}  // namespace sonde
