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
  /// eigenvalues of the hardest contact (contact_stability.hpp). No value if the path meets no
  /// contact that holds still, or if there is no limit.
  std::optional<double> stable;
  /// The same for passivity; 0 if no stiffness is passive: if the rendered wrench is no gradient
  /// (cycle_lever), as for a force without its torque.
  std::optional<double> passive;
  std::optional<double> passive_in_translation;  ///< the same with the turn of the handle held
  /// J per m of travel and rad of a turn's half range that a slow cycle can gain with this
  /// coupling.
  double cycle_lever = 0;
  /// The force, N, that the coupling renders at a tick of the path with the largest stiffness of
  /// that contact: at the same ticks for every method, some `limits_looked_at` of them.
  struct ForceAtLimit {
    std::size_t tick = 0;
    double force = 0;
  };
  std::vector<ForceAtLimit> limits = {};
};
constexpr std::size_t limits_looked_at = 48;

/// Computed at some 200 contacts of the path. For PD_t only the translation counts, without the
/// torque of its contacts. Throws Cancelled.
StableStiffness stable_stiffness(const RenderSetup& setup, Method method,
                                 std::span<const TimedPose> path,
                                 const SimulatedDeviceParameters& device, double sample_time,
                                 const Stop& stop);

std::string to_json(const StableStiffness& stiffness);
/// Throws InputError, naming `source`, if the text is not of this kind.
StableStiffness stable_stiffness_of(const std::string& json, const std::string& source);

}  // namespace sonde
