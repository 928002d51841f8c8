// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/calibration/calibration.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// The tick budget of the servo's settings: the given one or, if they specify an accuracy, the
/// least time from which that is expected (none if no time suffices).
Budget tick_budget(const ServoSettings& servo, const Pair& pair, Method method,
                   const Calibration& calibration);

}  // namespace sonde
