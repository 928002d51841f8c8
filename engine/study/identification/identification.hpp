// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/study/identification/handle_fit.hpp"

namespace sonde {

/// The properties of the device identified along one axis (0 to 2: force along x, y, z; 3 to 5:
/// torque about them).
struct IdentifiedAxis {
  std::size_t axis = 0;
  HandleFit handle;
  Estimate resolution;        ///< m | rad
  bool has_steps = false;     ///< false: no step was seen, and `resolution` is its upper bound
  std::size_t pulses = 0;     ///< number of pulses used
  std::size_t with_gaps = 0;  ///< number of other pulses, in which samples are missing
  double most = 0;            ///< N | N·m, the largest command among the used ones
};
/// An axis whose pulses are not sufficient for an identification.
struct RefusedAxis {
  std::size_t axis = 0;
  std::string reason;
};

/// One value for the three axes of a kind, as in profiles: the mean, and an interval that contains
/// those of all axes.
struct IdentifiedKind {
  Estimate inertia;     ///< kg | kg·m²
  Estimate damping;     ///< N·s/m | N·m·s/rad
  Estimate friction;    ///< N | N·m
  Estimate resolution;  ///< m | rad
};

struct Identification {
  std::vector<IdentifiedAxis> axes;
  std::vector<RefusedAxis> refused;
  std::optional<IdentifiedKind> translation,
      rotation;            ///< if an axis of the kind was identified
  Estimate delay;          ///< s, of all axes
  double sample_time = 0;  ///< s, the median
};

/// What is known of the rows of a recording.
enum class Rows {
  maybe_missing,  ///< a row that comes late may follow others that were not logged
  all_logged,     ///< a row that comes late is a late tick; its device held the command before it
};

/// Delay, mass, damping, Coulomb friction and encoder step from a handle's response to pulses, as
/// plan_pulses() makes them. Limits of the accuracy: for all values, the steps of the encoder and
/// the number of pulses; the delay is resolved to a share of the sample time only as far as the
/// recorded times are true; friction is one number, the same at rest and in motion. An axis is
/// refused, with a reason, if its pulses are not sufficient: no movement, too few or too short
/// pulses, a single amplitude, noise, another axis at the same time, gaps in time in all but a few,
/// a hand on the handle or a stop in its way. If all rows were logged, a late one is no gap, up to
/// 20 ms, and a position that is told twice is left out, not its pulse. Throws InputError, with the
/// reasons, if no axis remains; Cancelled if the progress stops it.
Identification identify(const Response& response, Rows rows = Rows::maybe_missing,
                        const Progress& progress = {});

/// "force along x", "torque about z".
std::string name_of_axis(std::size_t axis);

}  // namespace sonde
