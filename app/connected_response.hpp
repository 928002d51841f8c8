// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/base/error.hpp"
#include "engine/settings/device_profile.hpp"
#include "engine/study/identification/pulse_plan.hpp"
#include "engine/study/identification/response.hpp"

namespace sonde::app {

/// A device's answer to pulses, and the profile that they were planned by: the one given, with the
/// limits of force and torque that the device itself says.
struct ConnectedResponse {
  Response response;
  DeviceProfile profile;
};

/// Gives pulses to the connected device at `path` (as `sonde devices` lists it) and records its
/// answer, in the servo's real threads, far from any contact. An interrupt ends the force at once.
/// Throws InputError that names the device, where it does not open, has no motors, or the
/// measurement ended early; Cancelled where `progress` or an interrupt says so.
ConnectedResponse connected_response(const std::string& path, const DeviceProfile& profile,
                                     const PulseLimits& limits, const Progress& progress);

}  // namespace sonde::app
