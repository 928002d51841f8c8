// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/mass.hpp"
#include "engine/haptics/coupling/gain_glide.hpp"
#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// The largest stiffness that a device bears at the probe; 0: not known.
struct BorneStiffness {
  double translation = 0;  ///< N/m
  double rotation = 0;     ///< N·m/rad
};

/// By its maker's word.
BorneStiffness borne_by_device(const DeviceTraits& device) noexcept;

/// Where a sampled wall on this handle begins to swing in the lightest hand of a study, along one
/// axis: K (T/2 + t_d) = b, with b the damping of mechanism and hand. Translation and rotation each
/// by itself, so it is an estimate, and no replacement for a study. Not known where the device's
/// damping is not.
BorneStiffness stable_by_estimate(const DeviceTraits& device, double sample_time) noexcept;

/// The same gains, none stiffer than that. In the object norm the stiffness that a rotation feels
/// is up to 1.2 kÎ.
Coupling borne(const Coupling& wanted, const BorneStiffness& most,
               const MassProperties& mass) noexcept;

/// How much of the way from old gains to new ones may be made in all, so that none is stiffer than
/// that and stiffer than before; 1 between modes.
double share_of_way(const GainGlide& glide, const BorneStiffness& most,
                    const MassProperties& mass) noexcept;

}  // namespace sonde
