// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/study/stability/sampled_stability.hpp"

namespace sonde {

/// The hardness of a wall that a handle without a hand runs into: the mean rate at which the force
/// on the handle grows over the first 10 ms, over the speed at the surface (rate-hardness: Lawrence
/// and others, 2000), N/m | N·m/rad. The mean over all moments between two samples at which the
/// surface may be met: at one of them alone it would go in leaps of a sample. For an ideal spring
/// without other forces it is the spring's stiffness.
double rate_hardness(const SampledAxis& axis, double stiffness);

/// A spring and damper that holds the handle.
struct AxisHand {
  double stiffness = 0;  ///< N/m | N·m/rad
  double damping = 0;    ///< N·s/m | N·m·s/rad
};

/// The time in which the wall's force first rises from a tenth to nine tenths of its final value,
/// s, after a sudden push of a hand that held the handle at the surface, in the mean over the same
/// moments. The size of the push does not matter. Infinite if it does not reach that within 10 s.
double rise_time(const SampledAxis& axis, double stiffness, const AxisHand& hand);

}  // namespace sonde
