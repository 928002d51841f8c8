// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "app/python/interruptible.hpp"
#include "engine/base/threads.hpp"
#include "engine/sonde.hpp"

namespace sonde::python {

constexpr unsigned most_threads = 1024;

inline std::size_t threads_of(unsigned asked) {
  return std::clamp(asked == 0 ? std::thread::hardware_concurrency() : asked, 1U, most_threads);
}

/// The answer to every pose, a row each, on threads of its own: each thread's progress looks
/// whether it is to end. (How many threads the machine has takes longer to ask than a free pose.)
template <class Result>
std::vector<Result> of_every_pose(const std::vector<Pose>& poses, unsigned threads,
                                  const pybind11::object& told, const auto& answer) {
  std::vector<Result> rows(poses.size());
  interruptible(told, [&](Interruptible& state) {
    std::atomic<std::size_t> done{0};
    const double n = static_cast<double>(std::max<std::size_t>(1, poses.size()));
    run_parallel(poses.size(), poses.size() < 2 ? 1 : threads_of(threads), [&](std::size_t i) {
      const Progress progress = state.progress(
          [&](double part) { return std::min(1.0, (static_cast<double>(done) + part) / n); });
      if (!progress(0)) throw Cancelled();
      rows[i] = answer(poses[i], progress);
      ++done;
    });
    return 0;
  });
  return rows;
}

}  // namespace sonde::python
