// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>

namespace sonde {

/// Within its scope numbers are rounded to the nearest, and no operation ends the program, whatever
/// a calling program has set: bounds and exact predicates rest on the one, and infinity is a number
/// like others. Some ns where nothing is to be set.
class RoundToNearest {
 public:
  RoundToNearest() noexcept : other_(!is_set()) {
    if (!other_) return;
    std::feholdexcept(&before_);
    std::fesetround(FE_TONEAREST);
  }
  ~RoundToNearest() {
    if (other_) std::fesetenv(&before_);
  }
  RoundToNearest(const RoundToNearest&) = delete;
  RoundToNearest& operator=(const RoundToNearest&) = delete;

  /// The mode of the arithmetic itself is asked for as well: std::fegetround() may read that of
  /// another unit than the one that computes.
  static bool is_set() noexcept {
    const volatile double one = 1, little = 0x1p-60;
    return one + little == 1 && one - little == 1 && std::fegetround() == FE_TONEAREST &&
           !has_traps();
  }

 private:
  static bool has_traps() noexcept {
#if defined(__SSE2__)
    constexpr unsigned all = 0x1f80;
    return (__builtin_ia32_stmxcsr() & all) != all;
#elif defined(__GLIBC__)
    return fegetexcept() != 0;
#else
    return false;
#endif
  }

  bool other_;
  std::fenv_t before_;
};

}  // namespace sonde
