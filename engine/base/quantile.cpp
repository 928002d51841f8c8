// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sonde {

double quantile(std::span<const double> sorted, double share) {
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

}  // namespace sonde
