// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "engine/haptics/loop/loop_tuning.hpp"

namespace sonde {

/// The wall-clock limit of each refresh of the geometry: the budget of a tick as long as the
/// answers converge, and twice the last limit after one that has not. A limit cuts work off that
/// the next refresh must do again, so a constant one can be too short for ever: where parts fit
/// into each other, one look at what is near may take longer than a tick. With limits that double,
/// the refreshes before the one that suffices take no longer together than that one.
class RefreshLimit {
 public:
  /// µs; `budget_us` is that of a tick. 0: no limit.
  double of(double budget_us) const noexcept {
    return std::max(budget_us, std::min(factor_ * budget_us, loop_tuning.longest_refresh_us));
  }
  /// Whether the last refresh converged.
  void learn(bool converged) noexcept { factor_ = converged ? 1 : std::min(2 * factor_, 1e9); }

 private:
  double factor_ = 1;
};

}  // namespace sonde
