// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>

namespace sonde {

/// The calling thread and at most one more, which lives as long as this does: thousands of small
/// pieces of work, where starting a thread for each would cost as much as they do.
class ThreadPair {
 public:
  /// work(k, lane), for k < count; the lane is k % 2. What one lane does is done in order, so that
  /// it may have a memory.
  using Work = std::function<void(std::size_t k, std::size_t lane)>;

  explicit ThreadPair(bool two_threads) : two_threads_(two_threads) {}
  ~ThreadPair();
  ThreadPair(const ThreadPair&) = delete;
  ThreadPair& operator=(const ThreadPair&) = delete;

  /// All of k < count, each once. Returns when all are done. Work must not throw. Where the other
  /// thread has not come by the time this one is done with its lane, it does both.
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
