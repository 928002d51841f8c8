// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace sonde {

/// The smallest of the values that is not exceeded by the given share (0 to 1) of them (nearest
/// rank): always one of the values, which must be sorted; NaN if there are none.
double quantile(std::span<const double> sorted, double share);

}  // namespace sonde
