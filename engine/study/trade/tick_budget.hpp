// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/calibration/calibration.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// The budget of a tick that the servo's settings ask for: the one given, or where they name an
/// accuracy, the least time from which that is expected (none where no time suffices).
Budget tick_budget(const ServoSettings& servo, const Pair& pair, Method method,
                   const Calibration& calibration);

}  // namespace sonde
