// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "engine/geometry/chart.hpp"
#include "engine/proximity/sweep/sweep.hpp"

namespace sonde {

/// The step, or the part of it with that length, m of y.
Vec6 shortened(const Vec6& step, double longest);

/// What a descent expects of its next step, from the steps so far.
struct Pace {
  double scale = 0;    ///< m: typical length of a step
  double bending = 0;  ///< κ, 1/m: how strongly contacts were found to bend into the path
  /// m: limit of the length of a step, and of the path of any point of the probe, since long ones
  /// are expensive to sweep. (If the device is half a turn ahead, the path is far longer than the
  /// step.)
  double longest = std::numeric_limits<double>::max();
  /// m: limit of the damped step. Obstacles are still searched for up to the end of the undamped
  /// step: obstacles there whose rows are missing make the steps oscillate.
  double damped_to = std::numeric_limits<double>::max();
  /// m: |y| never rises above this.
  double ceiling = std::numeric_limits<double>::max();
  Vec6 last = Vec6::Zero();    ///< the last step, after damping
  Vec6 wanted = Vec6::Zero();  ///< the last step, before damping
  Vec6 steady = Vec6::Zero();  ///< the last step that continued the one before it
  double ratio = 0;            ///< its length over that of the one before it; 0: none is known
  bool in_series = false;      ///< that ratio was the same twice in a row, and no step has differed
  bool extrapolates = false;   ///< the last step was an extrapolated one
  double went = 0;             ///< m: the distance it moved
  int returns = 0;             ///< number of consecutive steps that turned back
  int stalled = 0;             ///< number of consecutive steps without progress

  /// Steps that undo each other straddle a sharp edge. The wanted step changes about linearly from
  /// pose to pose, so it vanishes between the last pose and this one, and the step ends there
  /// (secant method). If secant steps do not settle it, the steps are halved.
  Vec6 damped(const Vec6& step) noexcept;
  /// A straight path leaves an obstacle that curves away from it; the next step returns to it, and
  /// goes on. Where the obstacle is nearly as curved as the sphere of its |y|, such steps make up a
  /// geometric series. Once the last three did, returns the sum of those to come (Aitken's
  /// extrapolation), from y on; if they grow, of those up to twice as long. It is at most `most`
  /// times the step, and does not raise |y| above the ceiling. No value if that is not worth a
  /// look.
  std::optional<Vec6> extrapolated(const Vec6& y, const Vec6& step, double most) noexcept;
  /// The multiple of a step from y that ends on the ceiling.
  double to_ceiling(const Vec6& y, const Vec6& step) const noexcept;
  /// What was taken for a series is none.
  void end_series() noexcept { ratio = 0, in_series = false; }
  /// After a step and the sweep of its path. A step that moved by no more than `worth_while` (m)
  /// made no progress. `radius`: of the probe, m.
  void learn(const Vec6& step, const Sweep& swept, double worth_while, double radius) noexcept;
};

}  // namespace sonde
