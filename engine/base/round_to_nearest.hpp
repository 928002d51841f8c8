// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>

namespace sonde {

/// Within its scope numbers are rounded to the nearest, whatever a calling program has set: bounds
/// and exact predicates rest on that. 2 ns where nothing is to be set.
class RoundToNearest {
 public:
  RoundToNearest() noexcept : other_(!is_set()) {
    if (!other_) return;
    std::fegetenv(&before_);
    std::fesetround(FE_TONEAREST);
  }
  ~RoundToNearest() {
    if (other_) std::fesetenv(&before_);
  }
  RoundToNearest(const RoundToNearest&) = delete;
  RoundToNearest& operator=(const RoundToNearest&) = delete;

  /// Asks the arithmetic itself: std::fegetround() may read another unit's mode than the one that
  /// computes.
  static bool is_set() noexcept {
    const volatile double one = 1, little = 0x1p-60;
    return one + little == 1 && one - little == 1;
  }

 private:
  bool other_;
  std::fenv_t before_;
};

}  // namespace sonde
