// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace sonde {

/// The least of the values that the given share (0 to 1) of them does not exceed (nearest rank):
/// always one of them. The values must be in order; NaN where there are none.
double quantile(std::span<const double> sorted, double share);

}  // namespace sonde
