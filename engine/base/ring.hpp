// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sonde {

/// A lock-free queue from one writing thread to one reading thread. If the reader does not keep up,
/// new items are dropped and counted: the writer never waits. Allocates only in its constructor.
template <class T>
class Ring {
 public:
  explicit Ring(std::size_t capacity) : items_(capacity + 1) {}
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  /// For the writer. Returns false if there was no room.
  bool push(const T& item) noexcept {
    const std::size_t at = end_.load(std::memory_order_relaxed);
    const std::size_t next = after(at);
    if (next == begin_.load(std::memory_order_acquire)) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    items_[at] = item;
    end_.store(next, std::memory_order_release);
    return true;
  }

  /// For the reader. Returns false if it is empty.
  bool pop(T& item) noexcept {
    const std::size_t at = begin_.load(std::memory_order_relaxed);
    if (at == end_.load(std::memory_order_acquire)) return false;
    item = items_[at];
    begin_.store(after(at), std::memory_order_release);
    return true;
  }

  std::uint64_t lost() const noexcept { return lost_.load(std::memory_order_relaxed); }

  /// Empties the ring and resets the losses. Only while no other thread uses the ring.
  void clear() noexcept {
    begin_.store(0, std::memory_order_relaxed);
    end_.store(0, std::memory_order_relaxed);
    lost_.store(0, std::memory_order_relaxed);
  }

 private:
  std::size_t after(std::size_t i) const { return i + 1 == items_.size() ? 0 : i + 1; }

  static constexpr std::size_t cache_line = 64;
  std::vector<T> items_;  ///< one more than the capacity, to distinguish full from empty
  alignas(cache_line) std::atomic<std::size_t> begin_{0};
  alignas(cache_line) std::atomic<std::size_t> end_{0};
  alignas(cache_line) std::atomic<std::uint64_t> lost_{0};
};

}  // namespace sonde
