// SPDX-License-Identifier: GPL-3.0-or-later
// The system's node of a HID device, by the path that hidapi gives it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sonde {

/// Numbers of errors, 0 where there was none.
struct HidNodeCheck {
  int opening = 0;  ///< it cannot be opened for reading and writing
  int asking = 0;   ///< it opens, and is no HID device
};
HidNodeCheck check_hid_node(const std::string& path);

/// Where it is plugged in, in the system's words; "" where that is not known.
std::string hid_port(const std::string& path);

/// Its report descriptor; empty where it cannot be read.
std::vector<std::uint8_t> hid_report_descriptor(const std::string& path);

}  // namespace sonde
