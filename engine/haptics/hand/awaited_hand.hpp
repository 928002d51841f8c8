// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "engine/haptics/hand/hand.hpp"

namespace sonde {

/// True once a loop that had the same device has ended.
using LoopEnded = std::shared_ptr<const std::atomic<bool>>;

/// A hand that is not asked before all of these loops have ended: a device is one loop's at a time.
/// Until then the probe stays at X_FM, without a force.
Hand awaited(Hand hand, std::vector<LoopEnded> before, const Pose& X_FM);

}  // namespace sonde
