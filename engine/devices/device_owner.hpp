// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sonde {

/// Which other program has the device open, or, where that is not ours to see, which driver daemon
/// (spacenavd, the vendor's own) runs and so may have it; one line, and empty where there is none.
/// `proc`: the system's folder of processes.
std::string other_owner(const std::string& path, const std::filesystem::path& proc = "/proc");

}  // namespace sonde
