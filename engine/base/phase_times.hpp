// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace sonde {

/// The phases of a search and of a tick.
enum class Phase {
  sketch,  ///< descents on the sketches of the bodies
  look,    ///< search for near pairs, and making rows of them
  solve,   ///< the least-distance problem of the rows
  sweep,   ///< the sweep of a path of the probe
  verify,  ///< tests whether a pose is free
  bound,   ///< the certified lower bound
  couple,  ///< from the separation to the wrench on the hand
};
/// The words for the phases in files, in the order of the enum.
inline constexpr std::array<const char*, 7> phase_names{"sketch", "look",  "solve", "sweep",
                                                        "verify", "bound", "couple"};
/// The number of phases.
inline constexpr std::size_t phase_count = phase_names.size();

/// Where the time of an answer went, µs of each thread's clock; with two threads, the sum of both.
/// Time between the phases is not included. All 0 unless requested.
struct PhaseTimes {
  std::array<double, phase_count> us{};  ///< in the order of Phase

  /// The time of one phase, µs.
  double& operator[](Phase phase) { return us[static_cast<std::size_t>(phase)]; }
  /// The time of one phase, µs.
  double operator[](Phase phase) const { return us[static_cast<std::size_t>(phase)]; }
  /// Adds the times of each phase.
  PhaseTimes& operator+=(const PhaseTimes& other) {
    for (std::size_t i = 0; i < phase_count; ++i) us[i] += other.us[i];
    return *this;
  }
  /// The time of all phases, µs.
  double sum() const {
    double out = 0;
    for (const double t : us) out += t;
    return out;
  }
};

}  // namespace sonde
