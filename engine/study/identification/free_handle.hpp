// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace sonde {

/// A free handle, along one axis of force (units on the left) or of torque (right).
struct FreeHandle {
  double inertia = 0.1;  ///< kg | kg·m²
  double damping = 0;    ///< N·s/m | N·m·s/rad, viscous
  double friction = 0;   ///< N | N·m, Coulomb friction, the same at rest and in motion
  double delay = 0;      ///< s, from a command to the measured motion that it causes
  double offset = 0;     ///< N | N·m, in addition to the command: gravity that is not compensated
};

/// Its motion, from rest at zero, in m | rad, at each of these times (s, ascending). Each command
/// (N | N·m) is given at the time with the same index and holds until the next.
///
///     m ẍ + b ẋ = f(t − t_d) + offset − friction
///
/// `early`, if not empty: by how much (s) each command was given before that time, less than the
/// time since the previous sample. Between commands, and between a start and a stop of the handle,
/// the equation is linear: this is its exact solution, for any times.
std::vector<double> free_motion(const FreeHandle& handle, std::span<const double> times,
                                std::span<const double> commands,
                                std::span<const double> early = {});

}  // namespace sonde
