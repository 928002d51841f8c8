// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/base/error.hpp"

namespace sonde {

/// More threads for long work.

/// Fewer triangles than this are done before a second thread has started.
constexpr std::size_t worth_a_thread = 20'000;

using Part = std::function<void(const Progress&)>;

/// Runs two independent parts of a step, `there` on a second thread if `two_threads` and after
/// `here` if not. Progress is called on this thread only; once it has cancelled `here`, the
/// progress of `there` also cancels. Throws what either throws.
void run_both(bool two_threads, const Progress& progress, const Part& here, const Part& there);

/// Calls task(i) for every i below n, each once, in any order, on that many threads, including this
/// one. The first exception ends it and is thrown here.
template <class Task>
void run_parallel(std::size_t n, std::size_t threads, const Task& task) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t i; (i = next++) < n;) task(i);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      next = n;
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(threads, n); ++i) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace sonde
