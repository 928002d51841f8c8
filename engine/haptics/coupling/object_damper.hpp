// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/chart.hpp"
#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// A damper beside the spring of the object norm, with one coefficient b (N·s/m). The spring is the
/// gradient of U = ½ k |y|², with y the coordinates of the separation (Chart). The damper is that
/// of the Rayleigh function R = ½ b |ẏ|² with respect to the motion of the device (ẋ, ω), where ẏ =
/// Y (ẋ, ω):
///
///     (F, τ) = −b Yᵀ ẏ,   a power on the hand of −b |ẏ|²
///
/// So it takes energy out whatever the contact is like. A force of b ẏ that ignores how Q follows
/// the device, as the classic coupling's, gives energy where a contact bends away from the probe:
/// there the separation turns faster than the device moves.

/// Y, with `d_separated` how Q moves with O (WrenchDerivative): rows as y, columns (ẋ, ω).
Mat6 separation_jacobian(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ,
                         const Mat6& d_separated);

/// The damper's wrench. Not sampled: `rate` is ẏ, m/s.
Wrench object_damper(const Mat6& jacobian, const Vec6& rate, double damping);

}  // namespace sonde
