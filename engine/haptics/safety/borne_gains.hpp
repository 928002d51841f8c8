// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/mass.hpp"
#include "engine/haptics/coupling/gain_glide.hpp"
#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// The largest stiffness that a device can hold, at the probe; 0: unknown.
struct BorneStiffness {
  double translation = 0;  ///< N/m
  double rotation = 0;     ///< N·m/rad
};

/// The stiffness that the device's maker states.
BorneStiffness borne_by_device(const DeviceTraits& device) noexcept;

/// The stiffness at which a sampled wall on this handle begins to oscillate in the lightest hand of
/// a study, along one axis: K (T/2 + t_d) = b, with b the damping of mechanism and hand.
/// Translation and rotation are treated separately, so it is an estimate, and no replacement for a
/// study. Unknown if the device's damping is unknown.
BorneStiffness stable_by_estimate(const DeviceTraits& device, double sample_time) noexcept;

/// The gains, reduced to that stiffness. In the object norm the stiffness felt in a rotation is up
/// to 1.2 kÎ.
Coupling borne(const Coupling& wanted, const BorneStiffness& most,
               const MassProperties& mass) noexcept;

/// The share of the way from old gains to new ones that may be made in all, so that no gain becomes
/// stiffer than both that limit and before; 1 between modes.
double share_of_way(const GainGlide& glide, const BorneStiffness& most,
                    const MassProperties& mass) noexcept;

}  // namespace sonde
