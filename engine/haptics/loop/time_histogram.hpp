// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/base/elementary.hpp"

namespace sonde {

/// A histogram of times with bins of equal ratio, from 0.1 µs to 1 s, forty in a decade (6 % wide).
/// Plain data, no allocation.
struct TimeHistogram {
  static constexpr int per_decade = 40;
  static constexpr int bins = 7 * per_decade;
  static constexpr double shortest = 0.1;  ///< µs

  std::array<std::uint32_t, bins>
      counts{};  ///< the first and the last bin include all values beyond
  std::uint64_t total = 0;
  double largest = 0;  ///< µs

  void add(double us) noexcept {
    const double place =
        us > shortest ? per_decade * elementary::log10(us / shortest) : 0;  // NaN: 0
    ++counts[place < bins ? static_cast<std::size_t>(place) : bins - 1];
    ++total;
    if (us > largest) largest = us;
  }
  /// µs: the upper edge of bin i.
  static double edge(int i) noexcept {
    return shortest * elementary::pow(10, (i + 1.0) / per_decade);
  }
  /// µs that the given share (0 to 1) of the times did not exceed: the upper edge of its bin, so
  /// never too low, and at most 6 % too high; the largest time if that is lower. 0 if there are no
  /// times yet.
  double quantile(double share) const noexcept {
    if (total == 0) return 0;
    const double wanted = std::ceil(share * static_cast<double>(total));
    std::uint64_t seen = 0;
    for (int i = 0; i + 1 < bins; ++i) {
      seen += counts[static_cast<std::size_t>(i)];
      if (seen > 0 && static_cast<double>(seen) >= wanted) return std::min(edge(i), largest);
    }
    return largest;
  }
};

}  // namespace sonde
