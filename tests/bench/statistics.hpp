// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace sonde::bench {

/// Times of single calls, µs: calls[pose][repetition].
using Calls = std::vector<std::vector<double>>;

/// Of an even number of values, the mean of the middle two. Throws std::invalid_argument where
/// there are none.
double median(std::vector<double> values);

/// The least value that at least the given share (0 to 1) of the values does not exceed (nearest
/// rank: always one of the values). Throws std::invalid_argument where there are none.
double percentile(std::vector<double> values, double share);

/// The median of the repetitions of each pose: what an interruption by the system does not touch.
std::vector<double> times_of_poses(const Calls& calls);

struct Statistics {
  std::size_t poses = 0;
  std::size_t calls = 0;
  double median_us = 0;  ///< over poses
  double p99_us = 0;     ///< over poses
  /// p99.9 / p99 over single calls; no value below 1000 calls, where p99.9 is the largest.
  std::optional<double> tail;
};
Statistics summarize(const Calls& calls);

/// Median of `theirs` / median of `ours`, both over the poses that both were timed at: a slow
/// library may have been given the first few alone.
double ratio_of_medians(const Calls& theirs, const Calls& ours);

}  // namespace sonde::bench
