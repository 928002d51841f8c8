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
/// Y treats each present contact as a plane: ẏ is the smallest change of y that keeps these
/// contacts, as y is the smallest displacement that separates. The curvature of contacts is
/// neglected. So on curved contacts, ẏ is not exactly the rate of the separation, but the damper
/// still dissipates, whatever the contacts. (A force b ẏ without Yᵀ, with the measured ẏ, would
/// not: where a contact curves away from the probe, the separation turns faster than the device
/// moves, and the force adds energy.)

/// The matrix Y: its rows are the components of y, its columns those of V. Zero out of contact.
/// Directions in which the contacts carry less than a thousandth of the load fade out of it.
Mat6 separation_jacobian(const MassProperties& mass, Method method,
                         const Separation& separation) noexcept;

/// The damper's wrench for the gains k and b_t. `before` is the device pose dt (s) ago. It is
/// scaled down, by one factor for all contacts so that it still dissipates, until spring and damper
/// together pull at no contact.
Wrench object_damper(const MassProperties& mass, Method method, const Separation& separation,
                     const Pose& before, double dt, const Coupling& coupling) noexcept;

}  // namespace sonde
