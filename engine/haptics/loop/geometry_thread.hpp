// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "engine/base/triple_buffer.hpp"
#include "engine/haptics/loop/contact_feed.hpp"

namespace sonde {

/// Refreshes the contact rows for the newest device pose as fast as it can, in its own thread. Of
/// the poses that arrive while it is busy, it takes only the newest.
class GeometryThread {
 public:
  GeometryThread(const Pair& pair, Method method, const Budget& budget, bool real_time = false);
  ~GeometryThread();  ///< stops the thread
  GeometryThread(const GeometryThread&) = delete;
  GeometryThread& operator=(const GeometryThread&) = delete;

  /// Starts at X_FM. If the probe overlaps there, it searches first, which can take a while.
  void start(const Pose& X_FM);
  void stop();  ///< returns after the current refresh has ended
  /// Sets the wall-clock limit of each refresh from the next one on, µs; 0: no limit. Any thread.
  void set_budget_us(double time_us) noexcept {
    budget_us_.store(time_us, std::memory_order_relaxed);
  }

  /// Whether a refresh reports where its time went, from the next one on. Any thread.
  void set_time_phases(bool on) noexcept { time_phases_.store(on, std::memory_order_relaxed); }

  // For one other thread, the servo's: these neither allocate, lock nor wait.
  void ask(const Pose& X_FM, std::uint64_t tick, double time) noexcept;
  /// The newest rows, valid until the next call.
  const LocalContacts& newest() noexcept;

 private:
  struct Request {
    Pose X_FM;
    std::uint64_t tick = 0;
    double time = 0;
  };
  void run() noexcept;

  ContactFeed feed_;
  Budget budget_;  ///< without its time limit
  std::atomic<double> budget_us_;
  std::atomic<bool> time_phases_{false};
  bool real_time_;  ///< request a higher scheduling priority and a processor
  TripleBuffer<Request> requests_;
  TripleBuffer<LocalContacts> contacts_;
  std::atomic<std::int32_t> asked_{0};  ///< number of requests so far; the thread waits on it
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace sonde
