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

/// Upper bounds of the stiffness and damping that the hand feels with given gains, in any mode.
struct FeltGains {
  double k_t = 0, k_r = 0;  ///< N/m, N·m/rad
  double b_t = 0, b_r = 0;  ///< N·s/m, N·m·s/rad
};
FeltGains felt_gains(const Coupling& coupling, const MassProperties& mass) noexcept;

/// The largest gains that the device's maker states.
BorneGains borne_by_device(const DeviceTraits& device) noexcept;

/// The largest damping b_t of the object norm, N·s/m; 0: unknown. In a rotation the hand feels up
/// to 1.2 b_t Î.
double most_object_damping(const BorneGains& most, const MassProperties& mass) noexcept;

/// The damping, delay and inertia that are assumed for a device that does not state them, at its
/// handle: the least value of all bundled profiles, but the largest for the delay.
DeviceTraits assumed_traits() noexcept;

/// The stiffness at which a sampled virtual wall rendered on this handle begins to oscillate along
/// one axis, held by the light hand of a stability study (1 N·s/m): K (T/2 + t_d) = b, with b the
/// damping of mechanism, hand and coupling (of that at most m/(T + t_d)/6, with m the inertia; 0 if
/// it is unknown, since a damper may be too much for a light handle). T is the time between the
/// device's reports, where that is longer than a tick. Translation and rotation are treated
/// separately, so it is an estimate, and no replacement for a study. For an unknown device, that of
/// assumed_traits().
BorneGains stable_by_estimate(const DeviceTraits& device, double sample_time,
                              const Coupling& coupling, const MassProperties& mass) noexcept;

/// The gains `wanted`, reduced so that no stiffness and no damping exceeds `most`. In the object
/// norm, the hand feels up to 1.2 kÎ of the spring in a rotation, and 1.2 b_t Î of the damper.
Coupling borne(const Coupling& wanted, const BorneGains& most, const MassProperties& mass) noexcept;

/// Whether borne() reduced a gain that the mode uses.
bool is_reduced(const Coupling& borne, const Coupling& wanted) noexcept;

/// The largest share of a glide from old gains to new ones at which every stiffness is at or below
/// stable_by_estimate(), or no further above it than at the start. (The estimate changes along the
/// glide too, with the damping.) In a change to the classic mode or from it, the wrench is blended,
/// so the spring that is felt is at most the sum of both springs, each times its share; likewise
/// the damper.
double share_of_way(const GainGlide& glide, const DeviceTraits& device, double sample_time,
                    const MassProperties& mass) noexcept;

}  // namespace sonde
