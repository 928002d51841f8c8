// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/study/rendering/rendering.hpp"

namespace sonde {

/// The largest stiffness of a coupling on a device, in the contacts along a path.
struct StableStiffness {
  /// Largest stiffness against translation (stiffness_of; in the classic mode all gains of the
  /// springs grow together), N/m, at which the sampled loop is stable in every contact: by the
  /// eigenvalues of the contact that is hardest (contact_stability.hpp). No value where the path
  /// meets no contact that holds still, or where there is no end to it.
  std::optional<double> stable;
  /// The same of taking energy out of whatever holds the handle; 0 where at no stiffness: where
  /// the wrench rendered is no gradient (cycle_lever), as of a force without its torque.
  std::optional<double> passive;
  std::optional<double> passive_in_translation;  ///< the same with the turn of the handle held
  /// J for each m of way and rad of a turn's half range that a slow cycle can get at this coupling.
  double cycle_lever = 0;
  /// The force, N, that the coupling renders at a tick of the path where it is as stiff as that
  /// contact bears: at the same ticks for every method, some `limits_looked_at` of them.
  struct ForceAtLimit {
    std::size_t tick = 0;
    double force = 0;
  };
  std::vector<ForceAtLimit> limits = {};
};
constexpr std::size_t limits_looked_at = 48;

/// Computes it at some 200 contacts of the path. For PD_t only the translation counts, without the
/// torque of its contacts. Throws Cancelled.
StableStiffness stable_stiffness(const RenderSetup& setup, Method method,
                                 std::span<const TimedPose> path,
                                 const SimulatedDeviceParameters& device, double sample_time,
                                 const Stop& stop);

std::string to_json(const StableStiffness& stiffness);
/// Throws InputError, naming `source`, where the text is not one.
StableStiffness stable_stiffness_of(const std::string& json, const std::string& source);

}  // namespace sonde
