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
/// So it dissipates energy, whatever the contact is like. A damping force b ẏ that ignores how Q
/// follows the device, as in the classic coupling, adds energy where a contact bends away from the
/// probe: there the separation turns faster than the device moves.

/// The matrix Y. Its rows are the components of y, its columns those of (ẋ, ω). `d_separated` is
/// the derivative of Q with respect to O (WrenchDerivative).
Mat6 separation_jacobian(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ,
                         const Mat6& d_separated);

/// The damper's wrench. `rate` is the exact ẏ, m/s, not a difference of samples.
Wrench object_damper(const Mat6& jacobian, const Vec6& rate, double damping);

}  // namespace sonde
