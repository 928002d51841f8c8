// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/study/identification/pulse_plan.hpp"
#include "engine/study/identification/response.hpp"

namespace sonde {

/// The response of a simulated device without a hand to a plan. Throws std::invalid_argument as
/// SimulatedDevice does.
Response simulated_response(const SimulatedDeviceParameters& device, const PulsePlan& plan);

}  // namespace sonde
