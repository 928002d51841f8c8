// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "engine/study/identification/response.hpp"

namespace sonde {

/// A pulse of a recording, in samples, and the samples around it that are used: from shortly before
/// it until the handle has had as long again to stop, or another axis is commanded. `end` is one
/// past the last.
struct PulseWindow {
  std::size_t begin = 0, first = 0, last = 0, end = 0;
  double amplitude = 0;  ///< N | N·m, the largest size of its command
};

/// The recording along one axis (0 to 2: force, 3 to 5: torque).
struct AxisResponse {
  std::vector<double> times;      ///< s
  std::vector<double> commands;   ///< N | N·m
  std::vector<double> positions;  ///< m | rad, from the first pose
  std::vector<bool> others;       ///< another axis is commanded
  /// Samples, ascending, besides the first, at which the handle is assumed to be at rest: after
  /// gaps in which the commands are unknown.
  std::vector<std::size_t> at_rest;
  /// Samples whose position only repeats the one before, though the handle moves: not measured.
  /// Empty: there are none.
  std::vector<bool> repeats = {};
  bool measured(std::size_t sample) const { return repeats.empty() || !repeats[sample]; }
};
AxisResponse axis_response(const Response& response, std::size_t axis);

/// The pulses of one axis, in their order: commands that are not zero, between rests.
std::vector<PulseWindow> pulse_windows(const AxisResponse& response);

/// Number of samples of the window that were measured.
std::size_t measured_in(const AxisResponse& response, const PulseWindow& window);

/// The largest distance from the start of the pulse, in the unit of the positions.
double excursion(const std::vector<double>& positions, const PulseWindow& window);

}  // namespace sonde
