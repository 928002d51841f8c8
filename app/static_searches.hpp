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

/// How so many searches are shared out over the threads that were asked for.
struct SearchThreads {
  std::size_t at_once = 1;    ///< searches
  bool two_for_each = false;  ///< threads for one; the same bits
};
/// Two threads for each search, where there are few: each is then answered sooner. One for each
/// where there are many, the time for one is short, or it is not made by two: all are then answered
/// sooner.
SearchThreads threads_for(std::size_t searches, const SolverOptions& options, bool by_two = true);

/// A static search for each pose, on the requested threads. Every pose has its own seed, made from
/// the seed and its index, so the results do not depend on the number of threads.
std::vector<TimedSeparation> search_all(const Pair& pair, std::span<const Pose> poses,
                                        const SolverOptions& options, ProgressLine& progress);

/// Prints on stderr why pose `index` failed, if it did, even with --quiet.
void report_failure(const Separation& separation, std::size_t index);

}  // namespace sonde::app
