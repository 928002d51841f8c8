// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sonde {

/// For a program's first line: its standard streams carry bytes as they are written, and a terminal
/// shows them as UTF-8. Returns the arguments in UTF-8, without the program's name.
std::vector<std::string> begin_program(int count, const char* const* arguments);

/// The file of the running program; "" where that is not known.
std::filesystem::path program_file();

}  // namespace sonde
