// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "engine/devices/device_sample.hpp"

namespace sonde {

/// The mapping from a device axis to one axis of the motion.
struct AxisSetting {
  int source = 0;  ///< the device axis, 0 to 5 in the order of SixAxes; allows swaps
  bool inverted = false;
  double gain = 1;          ///< 0 switches the axis off
  double dead_zone = 0.05;  ///< a deflection up to this counts as zero; 0 to below 1
  double expo = 0;          ///< 0 to 1: finer response to small deflections; 0: linear
  bool operator==(const AxisSetting&) const = default;
};

struct AxisMap {
  std::array<AxisSetting, 6> axes{{{0}, {1}, {2}, {3}, {4}, {5}}};
  bool operator==(const AxisMap&) const = default;
};

/// The mapped deflections, each from -gain to gain. The part d of a deflection beyond the dead
/// zone, 0 to 1, becomes (1 - expo) d + expo d³. Continuous and increasing; full deflection stays
/// full. A source that is not an axis gives zero.
SixAxes mapped(const AxisMap& map, const SixAxes& deflection) noexcept;

/// The displacement, or the velocity, at full deflection.
struct Reach {
  double translation = 0.1;  ///< m, or m/s
  double rotation = 1;       ///< rad, or rad/s
};

/// Position control: the deflection is a displacement from the pose at rest, in the axes of the
/// fixed frame. X_FP: the probe in the fixed frame.
Pose position_controlled(const Pose& X_FP_rest, const SixAxes& mapped, const Reach& reach) noexcept;

/// The rest pose from which this deflection leads to X_FP by position control.
Pose position_at_rest(const Pose& X_FP, const SixAxes& mapped, const Reach& reach) noexcept;

/// Rate control: the deflection is a velocity, in the axes of the fixed frame and about the probe's
/// origin, for dt (s).
Pose rate_controlled(const Pose& X_FP, const SixAxes& mapped, const Reach& rate,
                     double dt) noexcept;

/// First-order low-pass filter: the value of `last` after dt (s) with the input `target`. Smooths
/// the steps of a device that reports at 62 Hz. With a time constant of 0 the output follows
/// immediately.
SixAxes smoothed(const SixAxes& last, const SixAxes& target, double dt,
                 double time_constant) noexcept;

}  // namespace sonde
