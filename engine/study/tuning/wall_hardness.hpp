// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/study/stability/sampled_stability.hpp"

namespace sonde {

/// How hard a wall feels that a handle runs into with no hand on it: the mean rate at which the
/// force on the handle grows over the first 10 ms, over the speed at the surface (rate-hardness:
/// Lawrence and others, 2000), N/m | N·m/rad. The surface is met just after a sample. An ideal
/// spring that nothing slows has its own stiffness.
double rate_hardness(const SampledAxis& axis, double stiffness);

/// A spring and damper that holds the handle.
struct AxisHand {
  double stiffness = 0;  ///< N/m | N·m/rad
  double damping = 0;    ///< N·s/m | N·m·s/rad
};

/// The time in which the wall's force first rises from a tenth to nine tenths of what it comes to,
/// s, where a hand that held the handle at the surface pushes from one moment to the next. The size
/// of the push does not count. Infinite where it does not come to that within 10 s.
double rise_time(const SampledAxis& axis, double stiffness, const AxisHand& hand);

}  // namespace sonde
