// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/static_searches.hpp"

#include <algorithm>
#include <iostream>
#include <thread>

#include "app/timed.hpp"
#include "engine/base/threads.hpp"
#include "engine/penetration/search/pose_seed.hpp"
#include "engine/penetration/search/static_search.hpp"

namespace sonde::app {
namespace {

unsigned thread_count(unsigned asked) {
  return std::max(1u, asked == 0 ? std::thread::hardware_concurrency() : asked);
}

/// From so many searches for each thread on, they are rather made side by side.
constexpr std::size_t many_for_a_thread = 2;
/// µs: a search of less time works on one thread anyway (SearchTuning::shortest_for_two_threads).
constexpr double short_time = 5000;

}  // namespace

SearchThreads threads_for(std::size_t searches, const SolverOptions& options, bool by_two) {
  const std::size_t threads = thread_count(options.threads);
  const bool is_short = options.budget.microseconds > 0 && options.budget.microseconds < short_time;
  if (!by_two || is_short || searches >= many_for_a_thread * threads)
    return {std::clamp<std::size_t>(searches, 1, threads), false};
  return {std::clamp<std::size_t>(threads / 2, 1, std::max<std::size_t>(searches, 1)), threads > 1};
}

std::vector<TimedSeparation> search_all(const Pair& pair, std::span<const Pose> poses,
                                        const SolverOptions& options, ProgressLine& progress) {
  std::vector<TimedSeparation> results(poses.size());
  std::atomic<std::size_t> done{0};
  const SearchThreads threads = threads_for(poses.size(), options);
  run_parallel(poses.size(), threads.at_once, [&](std::size_t i) {
    StaticOptions own = options.static_options();
    own.two_threads = threads.two_for_each;
    own.seed = seed_of_pose(options.seed, poses[i]);
    TimedSeparation& result = results[i];
    result.time_us = timed_us([&] { result.separation = separate_static(pair, poses[i], own); });
    progress.show("searching", ++done, poses.size());
  });
  progress.clear();
  return results;
}

void report_failure(const Separation& separation, std::size_t index) {
  if (separation.status != Status::failed) return;
  std::cerr << "sonde: pose " << index << " failed: " << separation.reason << '\n';
}

}  // namespace sonde::app
