// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/base/error.hpp"
#include "engine/settings/device_profile.hpp"
#include "engine/study/identification/pulse_plan.hpp"
#include "engine/study/identification/response.hpp"

namespace sonde::app {

/// Gives pulses to the connected device at `path` (as `sonde devices` lists it) and records its
/// answer, in the servo's real threads, far from any contact. The plan is that of `profile` with
/// the force and torque that the device says it can. An interrupt ends the force at once. Throws
/// InputError that names the device, where it does not open, has no motors, or the measurement
/// ended early; Cancelled where `progress` or an interrupt says so.
Response connected_response(const std::string& path, const DeviceProfile& profile,
                            const PulseLimits& limits, const Progress& progress);

}  // namespace sonde::app
