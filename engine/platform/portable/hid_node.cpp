// SPDX-License-Identifier: GPL-3.0-or-later
// hidapi says of its own what cannot be opened; before version 0.14 it does not tell the report
// descriptor.
#include "engine/platform/hid_node.hpp"

namespace sonde {

HidNodeCheck check_hid_node(const std::string&) { return {}; }

std::string hid_port(const std::string&) { return ""; }

std::vector<std::uint8_t> hid_report_descriptor(const std::string&) { return {}; }

}  // namespace sonde
