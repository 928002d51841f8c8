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

/// A static search for each pose, on the threads asked for. Every pose has a seed of its own, made
/// of the seed and its index: the results do not depend on the number of threads.
std::vector<TimedSeparation> search_all(const Pair& pair, std::span<const Pose> poses,
                                        const SolverOptions& options, ProgressLine& progress);

/// Says on stderr why pose `index` failed, if it did. Failures are said even where quiet is asked.
void report_failure(const Separation& separation, std::size_t index);

}  // namespace sonde::app
