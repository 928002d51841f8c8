// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/static_searches.hpp"

#include <algorithm>
#include <bit>
#include <iostream>
#include <thread>

#include "app/timed.hpp"
#include "engine/base/threads.hpp"

namespace sonde::app {
namespace {

/// The splitmix64 step, which tells neighbouring numbers well apart.
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// The seed of a search, by the bits of its pose: the answer does not depend on the row, the file,
/// the thread or the shard that the pose stands in. q and −q are one turn, and 0 has no sign.
std::uint64_t seed_of(std::uint64_t seed, const Pose& pose) {
  const Eigen::Vector4d q = pose.q.coeffs();
  const auto first = std::find_if(q.begin(), q.end(), [](double x) { return x != 0; });
  const double sign = first != q.end() && *first < 0 ? -1 : 1;
  std::uint64_t out = mixed(seed);
  for (const double x :
       {pose.p.x(), pose.p.y(), pose.p.z(), sign * q[0], sign * q[1], sign * q[2], sign * q[3]})
    out = mixed(out ^ std::bit_cast<std::uint64_t>(x + 0.0));
  return out;
}

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
    own.seed = seed_of(options.seed, poses[i]);
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
