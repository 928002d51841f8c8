// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "engine/settings/device_profile.hpp"

namespace sonde::test {

/// The folder of the profiles that ship.
inline const std::filesystem::path bundled = SONDE_RESOURCES "/devices";

/// One of them, as a device has it that nobody has measured.
inline DeviceProfile assumed_profile() {
  return read_device_profile(SONDE_RESOURCES "/devices/sigma.7.json");
}

}  // namespace sonde::test
