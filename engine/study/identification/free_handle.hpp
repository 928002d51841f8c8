// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace sonde {

/// A handle that nobody holds, along one axis of force (units on the left) or of torque (right).
struct FreeHandle {
  double inertia = 0.1;  ///< kg | kg·m²
  double damping = 0;    ///< N·s/m | N·m·s/rad, viscous
  double friction = 0;   ///< N | N·m, Coulomb's, at rest the same as in motion
  double delay = 0;      ///< s, from a command to the motion that it causes, as it is measured
  double offset = 0;     ///< N | N·m, beside the command: gravity that is not compensated
};

/// Its motion, from rest at zero, in m | rad, at each of these times (s, rising). Each command (N |
/// N·m) is given at the time with the same index and holds until the next.
///
///     m ẍ + b ẋ = f(t − t_d) + offset − friction
///
/// `early`, if there are any: s, by which each command was given before that time, less than the
/// time since the sample before. Between commands, and between a start and a stop of the handle,
/// the equation is linear: this is its exact solution, whatever the times.
std::vector<double> free_motion(const FreeHandle& handle, std::span<const double> times,
                                std::span<const double> commands,
                                std::span<const double> early = {});

}  // namespace sonde
