// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace sonde {

/// Passes the newest value from one writing thread to one reading thread, without a lock: the
/// writer never waits and the reader never sees a partial value. One of the three slots belongs to
/// the writer and one to the reader. The third is exchanged between them, with a bit that says
/// whether it is new.
template <class T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& value = T{}) { fill(value); }
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  // For the writer.
  T& back() { return slots_[back_].value; }  ///< to be filled; holds an older value
  void publish() {
    const unsigned old = middle_.exchange(back_ | fresh, std::memory_order_acq_rel);
    back_ = old & index;
  }
  void write(const T& value) {
    back() = value;
    publish();
  }

  // For the reader.
  /// Takes over the newest value; returns false if nothing was published since the last call.
  bool update() {
    if ((middle_.load(std::memory_order_relaxed) & fresh) == 0) return false;
    const unsigned old = middle_.exchange(front_, std::memory_order_acq_rel);
    front_ = old & index;
    return true;
  }
  const T& front() const { return slots_[front_].value; }  ///< unchanged until the next update()

  /// Resets to a value that is not new. Only while no other thread uses the buffer.
  void fill(const T& value) {
    for (Slot& slot : slots_) slot.value = value;
    back_ = 0;
    front_ = 2;
    middle_.store(1, std::memory_order_relaxed);
  }

 private:
  static constexpr unsigned index = 3;
  static constexpr unsigned fresh = 4;
  static constexpr std::size_t cache_line = 64;

  /// In separate cache lines, to avoid false sharing between the two sides.
  struct alignas(cache_line) Slot {
    T value{};
  };
  std::array<Slot, 3> slots_;
  alignas(cache_line) unsigned back_ = 0;
  alignas(cache_line) std::atomic<unsigned> middle_{1};
  alignas(cache_line) unsigned front_ = 2;
};

}  // namespace sonde
