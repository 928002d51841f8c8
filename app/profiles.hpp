// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/settings/device_profile.hpp"

namespace sonde::app {

/// The profile of a device by its id, among those of the installed program or of the tree it was
/// built in, or by the path of its file. Throws UsageError, with the known ids, where it is none
/// of them; InputError where a file cannot be used.
DeviceProfile device_named(const std::string& id);

}  // namespace sonde::app
