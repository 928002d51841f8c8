// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/bodies.hpp"
#include "app/options.hpp"
#include "app/progress_line.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde::app {

/// A separation and the time its computation took.
struct TimedSeparation {
  Separation separation;
  double time_us = 0;
};

/// A static search for each pose, on the requested threads. Every pose has its own seed, made from
/// the seed and its index, so the results do not depend on the number of threads.
std::vector<TimedSeparation> search_all(const Pair& pair, std::span<const Pose> poses,
                                        const SolverOptions& options, ProgressLine& progress);

/// Prints on stderr why pose `index` failed, if it did, even with --quiet.
void report_failure(const Separation& separation, std::size_t index);

}  // namespace sonde::app
