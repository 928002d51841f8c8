// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/chart.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// A damper beside the spring of the object norm, with one coefficient b (N·s/m). The spring is the
/// gradient of U = ½ k |y|², with y the coordinates of the separation (Chart). The damper is that
/// of the Rayleigh function R = ½ b |ẏ|² with respect to the motion of the device V = (ẋ, ω), m/s
/// and rad/s in the fixed frame, at the probe's centre of mass. With ẏ = Y V:
///
///     (F, τ) = −b Yᵀ Y V,   a power on the hand of −b |Y V|² ≤ 0
///
/// Y is that of contacts as they are now, each a plane: ẏ is the least change that keeps them, as
/// y is the least that separates. How a contact bends is left out, so on bent contacts R is that of
/// another rate than the separation's own, but still dissipates, whatever the contact is like. (A
/// force b ẏ without Yᵀ, with the measured ẏ, would not: it adds energy where a contact bends away
/// from the probe, since the separation turns faster there than the device moves.)

/// The matrix Y: its rows are the components of y, its columns those of V. Zero out of contact. A
/// direction in which contacts carry less than a thousandth of the load fades out of it.
Mat6 separation_jacobian(const MassProperties& mass, Method method,
                         const Separation& separation) noexcept;

/// The damper's wrench for the gains k and b_t, with the device at `before` dt (s) ago. It is
/// lessened, by one factor for all contacts so that it dissipates, until spring and damper together
/// pull at none of them.
Wrench object_damper(const MassProperties& mass, Method method, const Separation& separation,
                     const Pose& before, double dt, const Coupling& coupling) noexcept;

}  // namespace sonde
