// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/static_searches.hpp"

#include <algorithm>
#include <iostream>
#include <thread>

#include "app/timed.hpp"
#include "engine/base/threads.hpp"
#include "engine/penetration/search/pose_seed.hpp"

namespace sonde::app {
namespace {

unsigned thread_count(unsigned asked) {
  return std::max(1u, asked == 0 ? std::thread::hardware_concurrency() : asked);
}

}  // namespace

std::vector<TimedSeparation> search_all(const Pair& pair, std::span<const Pose> poses,
                                        const SolverOptions& options, ProgressLine& progress) {
  std::vector<TimedSeparation> results(poses.size());
  std::atomic<std::size_t> done{0};
  // A search uses two threads itself.
  const unsigned threads = thread_count(options.threads);
  const std::size_t run_both =
      std::clamp<std::size_t>(threads / 2, 1, std::max<std::size_t>(poses.size(), 1));
  run_parallel(poses.size(), run_both, [&](std::size_t i) {
    StaticOptions own = options.static_options();
    own.two_threads = threads > 1;
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
