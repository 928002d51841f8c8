// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

#include "engine/base/progress.hpp"
#include "engine/geometry/pose.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

struct InsertionPath;

/// The least clearance along a path that is free, or along the part of it that is.
struct LeastRoom {
  double clearance = std::numeric_limits<double>::infinity();  ///< m: found at `X_FM`
  double travel = 0;                                           ///< m: where
  Pose X_FM;                                                   ///< the pose there
  /// m: nowhere on the path up to `searched` is the clearance less than `clearance − tolerance`.
  double tolerance = 0;
  double searched = 0;    ///< m of travel
  bool complete = false;  ///< the limit of work did not end the search
};

/// Finds the least clearance on a free path: throughout, not at samples. `found` is one that is
/// known, and its place. The tolerance is 1e-3 of the clearance, or 1e-9 of the probe's radius or
/// eight times the rounding of coordinates where those are more. A sweep that keeps what was found
/// less the tolerance proves that there is nothing below, or ends where there is; from there the
/// search goes down to the next minimum, and sweeps on. `work` limits it, in units of Effort.
/// Throws Cancelled.
/// @pre The path is free.
LeastRoom least_room(const Pair& pair, const InsertionPath& way, const LeastRoom& found,
                     std::int64_t work, const Progress& progress = {});

}  // namespace sonde
