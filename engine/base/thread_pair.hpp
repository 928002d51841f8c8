// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>

namespace sonde {

/// The calling thread and at most one more, which lives as long as this object. For thousands of
/// small pieces of work: starting a thread for each would cost as much as the work.
class ThreadPair {
 public:
  /// work(k, lane), for k < count; the lane is k % 2. The work of one lane is done in order, so it
  /// may keep state.
  using Work = std::function<void(std::size_t k, std::size_t lane)>;

  explicit ThreadPair(bool two_threads) : two_threads_(two_threads) {}
  ~ThreadPair();
  ThreadPair(const ThreadPair&) = delete;
  ThreadPair& operator=(const ThreadPair&) = delete;

  /// Runs work for all k < count, each once, and returns when all are done. Work must not throw. If
  /// the other thread has not started by the time this one has finished its lane, this one does
  /// both lanes.
  void each(std::size_t count, const Work& work);

 private:
  void help();
  void run_lane(std::size_t lane);

  bool two_threads_;
  std::thread other_;  // started when first needed
  const Work* work_ = nullptr;
  std::size_t count_ = 0;
  enum class Lane : int { idle, offered, taken, done, over };
  std::atomic<Lane> other_lane_ = Lane::idle;
};

}  // namespace sonde
