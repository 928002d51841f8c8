// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/base/effort.hpp"
#include "engine/proximity/sweep/sweep.hpp"

namespace sonde {

/// A long sweep in slices, between which it can be stopped. The bounds of a motion that turns are
/// loose over a long slice, and may take minutes; so a slice that takes too much work is given up,
/// and a shorter one is taken. By work and not by a clock: the slices are the same everywhere.
class SweepSlices {
 public:
  /// Of the piece of a path: the length of the next slice.
  double length() const { return length_; }
  /// Sweeps a slice: sweep_slice(Effort&).
  template <class SweepSlice>
  Sweep sweep(Effort& all, const SweepSlice& sweep_slice) {
    std::int64_t left = 0;
    const Sweep swept = all.at_most(work_, [&](Effort& part) {
      const Sweep out = sweep_slice(part);
      left = part.left();
      return out;
    });
    if (swept.given_up) {
      length_ *= 0.25;
      if (!(swept.free_until > 0)) work_ *= 2;
    } else if (!swept.hit && 3 * left > 2 * work_) {
      length_ = std::min(1.0, 2 * length_);
    }
    return swept;
  }

 private:
  static constexpr std::int64_t first_work = 2'000'000;  // units of Effort: some 20 ms
  double length_ = 1;
  std::int64_t work_ = first_work;
};

}  // namespace sonde
