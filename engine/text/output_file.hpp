// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace sonde {

/// Writes a file whole or not at all: to a temporary file beside it, which then takes its name. The
/// old file stays until that moment. A target that is not an ordinary file (a pipe, /dev/null) is
/// written directly. Throws InputError naming the file and the reason.
void write_whole(const std::filesystem::path& file, std::string_view text);

/// Throws what write_whole would throw for a folder that is missing or not writable: call it before
/// the work whose result is written.
void check_writable(const std::filesystem::path& file);

/// Writes everything to a file descriptor. False, with errno set, where that fails.
bool write_all(int descriptor, std::string_view text);

}  // namespace sonde
