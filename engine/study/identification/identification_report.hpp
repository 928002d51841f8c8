// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/settings/device_profile.hpp"
#include "engine/study/identification/identification.hpp"

namespace sonde {

/// The measured values with their intervals, beside those of `profile`, and for each axis the data
/// used, or why it was not used.
std::string identification_text(const Identification& identification, const DeviceProfile& profile);
/// The same as JSON, with the results of each axis.
std::string identification_json(const Identification& identification, const DeviceProfile& profile);

}  // namespace sonde
