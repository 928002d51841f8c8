// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/study/parts/study_parts.hpp"
#include "engine/study/stability/press_and_hold.hpp"

namespace sonde {

/// The gains that a sweep changes: the one k of the object norm; of the classic coupling k_t with
/// b_t, k_r with b_r, all four together, or both springs with b_t or with b_r alone.
enum class GainAxis { object, together, translation, rotation, together_b_t, together_b_r };
const char* name_of(GainAxis axis);
/// Both springs of the classic coupling, so that what holds can be recommended.
bool is_joint(GainAxis axis);
/// The damping is b_r, N·m·s/rad; else b_t, N·s/m.
bool damps_turns(GainAxis axis);

/// The faults that end the range of useful stiffness in a hold.
enum class HoldFault { none, unstable, saturated, chattering, unfaithful };
const char* name_of(HoldFault fault);
/// Unfaithful: motors further than fidelity_limit from what is commanded, in the torque where
/// rotation is swept, in the worse of both where all gains are, else in the force. The worst fault
/// is named.
HoldFault fault_of(const HoldReport& report, GainAxis axis);
/// A hand tells a difference of 7 to 10 % in force (Jones, 1989; Pang, Tan and Durlach, 1991).
constexpr double fidelity_limit = 0.1;

struct SweepPoint {
  double stiffness = 0;
  HoldReport report;
};

/// The least stiffness that fails, by the largest below it that is known to hold.
struct SweepLimit {
  double stiffness = 0;               ///< holds; 0 where nothing below the first fault does
  HoldFault fault = HoldFault::none;  ///< of the first that does not; none: the range's end
};

struct StiffnessSweep {
  std::vector<SweepPoint> points;  ///< by stiffness
  SweepLimit stable;               ///< below the least stiffness studied that is unstable
  /// Below the least fault of any kind that lies above something good: what is too soft to be good
  /// is no limit.
  SweepLimit good;
};

struct SweepOptions {
  GainAxis axis = GainAxis::object;
  double start = 500;  ///< a stiffness that is likely to hold; in [low, high]
  double low = 1;      ///< allowed range, both above zero
  double high = 1e5;
  /// Its sixteenth power is a step of the walk.
  double ratio = 1.02;
  /// Searches until the failing stiffness is at most this many times the holding one; not given:
  /// `ratio` times.
  std::optional<double> known_to = {};
  bool beyond = true;  ///< points above the limits too, for the map
};

/// Searches the limits of one gain. It walks upwards, from a quarter of the start (from further
/// below, where that fails) to the first unstable stiffness: in steps of ratio¹⁶ (1.1 to 2), in a
/// quarter of them where the last hold was slow to die down. Where none of these is good it looks
/// between one too soft to be faithful and its neighbour with another fault, then further down.
/// Then it bisects, to a ratio of 1.1 where nothing at all is good. A limit lies below every
/// observed fault, whatever holds above it. `run` is called once for each stiffness. Throws
/// Cancelled.
StiffnessSweep sweep_stiffness(const std::function<HoldReport(double stiffness)>& run,
                               const SweepOptions& options, const Stop& stop);

/// Swings less and less, or stands still; unlike a stable hold it may have left the contact. A hard
/// knock drives the probe out of a contact that does not buzz.
bool comes_to_rest(const HoldReport& report);

/// Searches for the least stiffness that does not hold, in the same way: the walk begins at the
/// start itself. Good for a second condition of a loop, of which a guess is known: fewer runs, no
/// other fault. Throws Cancelled.
SweepLimit search_limit(const std::function<HoldReport(double stiffness)>& run,
                        const std::function<bool(const HoldReport&)>& holds,
                        const SweepOptions& options, const Stop& stop);

}  // namespace sonde
