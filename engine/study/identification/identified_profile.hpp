// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/devices/device_sample.hpp"
#include "engine/settings/device_profile.hpp"
#include "engine/study/identification/identification.hpp"

namespace sonde {

/// A measured value of a profile.
struct IdentifiedValue {
  ProfileValue DeviceProfile::*value;
  Estimate estimate;
};
/// The measured values of mass, inertia, damping, friction, resolution and delay, each for
/// translation and rotation if the recording contains it.
std::vector<IdentifiedValue> identified_values(const Identification& identification);

const ProfileKey& key_of(ProfileValue DeviceProfile::*value);

/// The profile with these values instead of its own, with six digits, their intervals (no wider
/// than a profile allows), and `source`, which says how they were measured. Values that were not
/// measured stay.
DeviceProfile identified_profile(DeviceProfile profile, const Identification& identification,
                                 const std::string& source);

/// The profile with the limits that a connected device reports: these are more reliable than any
/// profile. A stiffness or damping that it does not report remains the profile's.
DeviceProfile with_limits_of(DeviceProfile profile, const DeviceCapabilities& can);

}  // namespace sonde
