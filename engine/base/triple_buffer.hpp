// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace sonde {

/// Passes the newest value from one writing thread to one reading thread, without a lock: the
/// writer never waits and the reader never sees half a value. Of the three slots one is the
/// writer's, one the reader's. The third changes hands in the middle, with a bit that says whether
/// it is fresh.
template <class T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& value = T{}) { fill(value); }
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  // The writer's side.
  T& back() { return slots_[back_].value; }  ///< to be filled; holds some older value
  void publish() {
    const unsigned old = middle_.exchange(back_ | fresh, std::memory_order_acq_rel);
    back_ = old & index;
  }
  void write(const T& value) {
    back() = value;
    publish();
  }

  // The reader's side.
  /// Takes over the newest value; false where nothing was published since the last call.
  bool update() {
    if ((middle_.load(std::memory_order_relaxed) & fresh) == 0) return false;
    const unsigned old = middle_.exchange(front_, std::memory_order_acq_rel);
    front_ = old & index;
    return true;
  }
  const T& front() const { return slots_[front_].value; }  ///< unchanged until the next update()

  /// Starts over with nothing fresh. Only while no other thread uses the buffer.
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

  /// Apart in memory, so that neither side slows the other down by writing next to it.
  struct alignas(cache_line) Slot {
    T value{};
  };
  std::array<Slot, 3> slots_;
  alignas(cache_line) unsigned back_ = 0;
  alignas(cache_line) std::atomic<unsigned> middle_{1};
  alignas(cache_line) unsigned front_ = 2;
};

}  // namespace sonde
