// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/study/stability/closed_loop.hpp"
#include "engine/study/stability/hand_course.hpp"

namespace sonde {

/// One tick of a trace.
struct TraceSample {
  double t = 0;      ///< s
  Wrench motors;     ///< on the handle, about the centre of mass, in F
  double depth = 0;  ///< m; 0 out of contact
};

/// The results of a trace.
struct TraceFigures {
  double force = 0;  ///< N, mean |F| over the last tenth of a second
  /// s from where the hand is steady until |F| stays within 5 % of `force`. None if it does not
  /// reach that before the last tenth of a second, or if no force is left.
  std::optional<double> settling_time;
  double overshoot = 0;  ///< largest |F| from where the hand is steady, over `force`, minus 1
  double energy = 0;     ///< J, net work of the motors on the handle; negative: done by the hand
  double chatter = 0;    ///< N, as HoldReport::chatter, at the end
  int jumps = 0;         ///< ticks that jumped to another place, as the engine reports it
  int failures = 0;      ///< ticks without an answer
};

struct TimeTrace {
  std::vector<TraceSample> samples;  ///< one for each tick
  TraceFigures figures;
};

/// Runs the loop through a course, from rest. Same input, same bits.
TimeTrace trace(ClosedLoop& loop, HandCourse course, const CoursePlace& place);

/// s until values `dt` apart stay within `band` (a share) of `last`; none if the final ones do not.
std::optional<double> settling_time(std::span<const double> values, double dt, double last,
                                    double band);

}  // namespace sonde
