// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/mass.hpp"
#include "engine/haptics/coupling/gain_glide.hpp"
#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// The largest gains that a device can hold, at the probe; 0: unknown.
struct BorneGains {
  double translation = 0;         ///< N/m
  double rotation = 0;            ///< N·m/rad
  double damping = 0;             ///< N·s/m, virtual
  double rotational_damping = 0;  ///< N·m·s/rad
};

/// The most that is felt of the gains of any mode.
struct FeltGains {
  double k_t = 0, k_r = 0;  ///< N/m, N·m/rad
  double b_t = 0, b_r = 0;  ///< N·s/m, N·m·s/rad
};
FeltGains felt_gains(const Coupling& coupling, const MassProperties& mass) noexcept;

/// Those that the device's maker states.
BorneGains borne_by_device(const DeviceTraits& device) noexcept;

/// The largest damping b_t of the object norm, N·s/m; 0: unknown. What is felt of it in a rotation
/// is up to 1.2 b_t Î.
double most_object_damping(const BorneGains& most, const MassProperties& mass) noexcept;

/// What is assumed of the damping, delay and inertia of a device of which they are not known, at
/// its handle: of each the least, and of the delay the most, of the profiles that ship.
DeviceTraits assumed_traits() noexcept;

/// The stiffness at which a sampled virtual wall rendered on this handle begins to oscillate along
/// one axis, held by the light hand of a stability study (1 N·s/m): K (T/2 + t_d) = b, with b
/// the damping of mechanism, hand and coupling (of that at most m/(T + t_d)/6, with m the inertia;
/// 0 if it is unknown, since a damper may be too much for a light handle). T is the time between
/// the device's reports, where that is longer than a tick. Translation and rotation are treated
/// separately, so it is an estimate, and no replacement for a study. For an unknown device:
/// of assumed_traits().
BorneGains stable_by_estimate(const DeviceTraits& device, double sample_time,
                              const Coupling& coupling, const MassProperties& mass) noexcept;

/// The gains `wanted`, reduced so that no stiffness and no damping exceeds `most`. In the object
/// norm, what is felt in a rotation is up to 1.2 kÎ, and of its damper 1.2 b_t Î.
Coupling borne(const Coupling& wanted, const BorneGains& most, const MassProperties& mass) noexcept;

/// Whether that reduced a gain that the mode uses.
bool is_reduced(const Coupling& borne, const Coupling& wanted) noexcept;

/// The share of the change from old gains to new ones that is allowed in all: as much as leaves
/// every stiffness at or below stable_by_estimate, which the damping changes with it, or no further
/// above it than before. In a change to the classic mode or from it, the wrench is blended, so the
/// spring that is felt is at most the sum of both springs, each with its share; and so is the
/// damper.
double share_of_way(const GainGlide& glide, const DeviceTraits& device, double sample_time,
                    const MassProperties& mass) noexcept;

}  // namespace sonde
