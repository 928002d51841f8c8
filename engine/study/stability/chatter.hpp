// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/geometry/chart.hpp"

namespace sonde {

/// What buzzes begins here, Hz: a hand moves up to about 10 Hz, and skin feels vibration best from
/// 40 Hz on.
constexpr double chatter_frequency = 50;

/// The share of a wrench's power above chatter_frequency, 0 to 1, of samples `sample_time` s apart:
/// its square root is how large what buzzes is beside the whole wrench, the steady part included.
/// `length` (m) turns torques into forces: the power is that of |F|² + |τ|²/length². A Hann window
/// keeps the steady part, and slow drift, out of the high frequencies. 0 where there is no force,
/// or fewer than eight samples.
double chatter_index(std::span<const Vec6> wrenches, double sample_time, double length);

}  // namespace sonde
