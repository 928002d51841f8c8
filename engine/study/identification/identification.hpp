// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/identification/handle_fit.hpp"

namespace sonde {

/// What a recording says of the device along one axis (0 to 2: force along x, y, z; 3 to 5: torque
/// about them).
struct IdentifiedAxis {
  std::size_t axis = 0;
  HandleFit handle;
  Estimate resolution;        ///< m | rad
  bool has_steps = false;     ///< false: no step was seen, and `resolution` is how large it may be
  std::size_t pulses = 0;     ///< that were used
  std::size_t with_gaps = 0;  ///< others, in which samples are missing
  double most = 0;            ///< N | N·m, the largest command among these
};
/// An axis along which there were pulses that cannot tell anything.
struct RefusedAxis {
  std::size_t axis = 0;
  std::string reason;
};

/// One value for the three axes of a kind, as profiles have it: the mean, and an interval that
/// holds those of all axes.
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
      rotation;            ///< where an axis of the kind was identified
  Estimate delay;          ///< s, of all axes
  double sample_time = 0;  ///< s, the median
};

/// Delay, mass, damping, Coulomb friction and encoder step from a handle's answer to pulses, as
/// plan_pulses() makes them. What limits each: the steps of the encoder and the number of pulses
/// limit all; delay is resolved to a share of the sample time only as far as the recording's times
/// are true; friction is one number, at rest as in motion. An axis is refused, with a reason, where
/// its pulses cannot tell: no movement, too few or too short pulses, one amplitude, noise, another
/// axis at the same time, gaps in time in all but a few, a hand on the handle or a stop in its way.
/// Throws InputError, with the reasons, where that leaves no axis.
Identification identify(const Response& response);

/// "force along x", "torque about z".
std::string name_of_axis(std::size_t axis);

}  // namespace sonde
