// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/settings/device_profile.hpp"
#include "engine/study/identification/identification.hpp"

namespace sonde {

/// The measured values with their intervals, beside those that `profile` has, and what was used of
/// each axis or why it was not.
std::string identification_text(const Identification& identification, const DeviceProfile& profile);
/// The same as JSON, and what each axis says.
std::string identification_json(const Identification& identification, const DeviceProfile& profile);

}  // namespace sonde
