// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/study/parts/study_parts.hpp"
#include "engine/study/stability/press_and_hold.hpp"

namespace sonde {

/// The gains that a sweep changes: the single k of the object norm; of the classic coupling, k_t
/// with b_t, k_r with b_r, all four together, or both springs with only b_t or only b_r; of the
/// damped object norm, k with b_t.
enum class GainAxis { object, together, translation, rotation, together_b_t, together_b_r, damped };
const char* name_of(GainAxis axis);
/// Throws std::invalid_argument if no axis has that name.
GainAxis gain_axis_named(std::string_view name);
/// The keys of the settings that it changes: "k", "k_t" or "k_r"; "b_t", "b_r" or, undamped, "".
const char* stiffness_key(GainAxis axis);
const char* damping_key(GainAxis axis);
/// Its spring is the single k of the object norm.
bool in_object_norm(GainAxis axis);
/// Both springs of the classic coupling, so that the result can be recommended.
bool is_joint(GainAxis axis);
/// Whether the damping is b_r, N·m·s/rad; otherwise it is b_t, N·s/m.
bool damps_turns(GainAxis axis);

/// The faults that end the range of useful stiffness in a hold.
enum class HoldFault { none, unstable, saturated, chattering, unfaithful };
const char* name_of(HoldFault fault);
/// The worst fault. Unfaithful: the motors differ from the command by more than fidelity_limit, in
/// the torque if rotation is swept, in the worse of both if all gains are, otherwise in the force.
HoldFault fault_of(const HoldReport& report, GainAxis axis);
/// A person perceives a difference of 7 to 10 % in force (Jones, 1989; Pang, Tan and Durlach,
/// 1991).
constexpr double fidelity_limit = 0.1;

struct SweepPoint {
  double stiffness = 0;
  HoldReport report;
};

/// The least stiffness that fails, given by the largest one below it that is known to hold.
struct SweepLimit {
  double stiffness = 0;               ///< holds; 0 if nothing below the first fault does
  HoldFault fault = HoldFault::none;  ///< of the first that fails; none: the end of the range
};

struct StiffnessSweep {
  std::vector<SweepPoint> points;  ///< by stiffness
  SweepLimit stable;               ///< below the least stiffness studied that is unstable
  /// Below the least fault of any kind above a good stiffness: one that is too soft to be good is
  /// no limit.
  SweepLimit good;
};

struct SweepOptions {
  GainAxis axis = GainAxis::object;
  double start = 500;  ///< a stiffness that is likely to hold; in [low, high]
  double low = 1;      ///< allowed range, both above zero
  double high = 1e5;
  /// A step of the walk is the sixteenth power of this.
  double ratio = 1.02;
  /// Searches until the failing stiffness is at most this multiple of the holding one; not given:
  /// `ratio`.
  std::optional<double> known_to = {};
  bool beyond = true;  ///< runs above the limits too, for the map
};

/// Searches the limits of one gain. It walks upwards, from a quarter of the start (from further
/// below, if that fails) to the first unstable stiffness: in steps of ratio¹⁶ (1.1 to 2), or a
/// quarter of that where the last hold decayed slowly. If none of these is good, it searches
/// between one too soft to be faithful and its neighbour with another fault, then further down.
/// Then it bisects, to a ratio of 1.1 if nothing at all is good. A limit lies below every observed
/// fault, whatever holds above it. `run` is called once for each stiffness. Throws Cancelled.
StiffnessSweep sweep_stiffness(const std::function<HoldReport(double stiffness)>& run,
                               const SweepOptions& options, const Stop& stop);

/// The oscillation decays, or the probe stands still; unlike in a stable hold, it may have left the
/// contact. A hard knock drives the probe out of a contact that does not buzz.
bool comes_to_rest(const HoldReport& report);

/// Searches for the least stiffness that does not hold, in the same way, but the walk begins at the
/// start itself. Useful for a second condition of a loop with a known estimate: fewer runs, no
/// other fault. Throws Cancelled.
SweepLimit search_limit(const std::function<HoldReport(double stiffness)>& run,
                        const std::function<bool(const HoldReport&)>& holds,
                        const SweepOptions& options, const Stop& stop);

}  // namespace sonde
