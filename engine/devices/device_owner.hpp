// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sonde {

/// The other program that has the device open. If we have no permission to see that, the running
/// driver daemon (spacenavd, the vendor's own) that may have it. One line; empty if there is none.
/// `proc`: the system's folder of processes.
std::string other_owner(const std::string& path, const std::filesystem::path& proc = "/proc");

}  // namespace sonde
