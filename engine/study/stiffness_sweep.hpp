// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "engine/study/press_and_hold.hpp"
#include "engine/study/study_parts.hpp"

namespace sonde {

/// What ends the range of useful stiffness in a hold.
enum class HoldFault { none, unstable, saturated, chattering, unfaithful };
const char* name_of(HoldFault fault);
/// Unfaithful: motors further than fidelity_limit from Hooke's law. The worst fault is named.
HoldFault fault_of(const HoldReport& report);
/// A hand tells a difference of 7 to 10 % in force (Jones, 1989; Pang, Tan and Durlach, 1991).
constexpr double fidelity_limit = 0.1;

struct SweepPoint {
  double stiffness = 0;
  HoldReport report;
};

/// The largest stiffness before the first that fails, looked for upwards from the start.
struct SweepLimit {
  double stiffness = 0;               ///< holds; 0 where none was found that does
  HoldFault fault = HoldFault::none;  ///< of the first that does not; none: the range's end
};

struct StiffnessSweep {
  std::vector<SweepPoint> points;  ///< by stiffness
  SweepLimit stable;               ///< the first fault that is instability
  SweepLimit good;                 ///< the first fault of any kind
};

struct SweepOptions {
  double start = 500;  ///< a stiffness that is likely to hold; in [low, high]
  double low = 1;      ///< allowed range, both above zero
  double high = 1e5;
  double ratio = 1.02;       ///< a limit is known when what fails is at most so many times as stiff
  bool surroundings = true;  ///< points well below and above the limits too, for the map
};

/// Looks for the limits of one gain: by doubling from the start (by halving, where that already
/// fails) until there is one that holds and one that does not, then by bisection of the ratio.
/// `run` is called once for each stiffness. Throws Cancelled.
StiffnessSweep sweep_stiffness(const std::function<HoldReport(double stiffness)>& run,
                               const SweepOptions& options, const Stop& stop);

}  // namespace sonde
