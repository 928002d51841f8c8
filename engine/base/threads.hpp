// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "engine/base/error.hpp"

namespace sonde {

/// Functions that run long work on several threads.

/// Work on fewer triangles than this is done before a second thread would have started.
constexpr std::size_t worth_a_thread = 20'000;

using Part = std::function<void(const Progress&)>;

/// Runs two independent parts of a step, `there` on a second thread if `two_threads` and after
/// `here` if not. Progress is called on this thread only; once it has cancelled `here`, the
/// progress of `there` also cancels. Throws what either throws.
void run_both(bool two_threads, const Progress& progress, const Part& here, const Part& there);

/// Calls task(i) for every i below n, each once, in any order, on `threads` threads, including this
/// one. The first exception ends it and is rethrown here.
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

/// Calls done(i, compute(i)) for every i below n in this order, one at a time, with compute on
/// `threads` threads, including this one. A result waits for those before it; no thread begins an
/// index further ahead than `ahead`. The first exception ends it and is rethrown here.
template <class Compute, class Done>
void run_in_order(std::size_t n, std::size_t threads, const Compute& compute, const Done& done,
                  std::size_t ahead = 4096) {
  using Result = decltype(compute(std::size_t{}));
  std::mutex mutex;
  std::condition_variable moved_on;
  std::map<std::size_t, Result> waiting;
  std::size_t next = 0, first = 0;  // next to begin; next to finish
  std::exception_ptr failure;
  const auto work = [&] {
    std::unique_lock lock(mutex);
    try {
      for (;;) {
        moved_on.wait(lock, [&] { return next >= n || next < first + ahead; });
        if (next >= n) return;
        const std::size_t i = next++;
        lock.unlock();
        Result result = compute(i);
        lock.lock();
        waiting.emplace(i, std::move(result));
        for (auto at = waiting.begin(); at != waiting.end() && at->first == first && !failure;
             at = waiting.begin()) {
          done(first, std::move(at->second));
          waiting.erase(at);
          ++first;
        }
        moved_on.notify_all();
      }
    } catch (...) {
      if (!lock.owns_lock()) lock.lock();
      if (!failure) failure = std::current_exception();
      next = n;
      moved_on.notify_all();
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
