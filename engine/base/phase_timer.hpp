// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/effort.hpp"
#include "engine/base/phase_times.hpp"

namespace sonde {

/// Adds its lifetime to a phase. Without times to add to, it does not read the clock, which would
/// cost some 50 ns. Timers must not nest, since the inner time would count twice.
class PhaseTimer {
 public:
  PhaseTimer(PhaseTimes* times, Phase phase) noexcept
      : into_(times ? &(*times)[phase] : nullptr), begin_(into_ ? now_us() : 0) {}
  ~PhaseTimer() {
    if (into_) *into_ += now_us() - begin_;
  }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double* into_;
  double begin_;
};

}  // namespace sonde
