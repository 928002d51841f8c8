// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sonde {

/// The other program that has the device open. Where we may not see that, the driver daemon
/// (spacenavd, the vendor's own) that runs and so may have it. One line; empty where there is none.
/// `proc`: the system's folder of processes.
std::string other_owner(const std::string& path, const std::filesystem::path& proc = "/proc");

}  // namespace sonde
