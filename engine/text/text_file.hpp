// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace sonde {

/// The whole content of a file, without a leading byte-order mark. Throws InputError naming the
/// file and the reason: missing, unreadable, a folder, empty, or longer than `most` bytes.
std::string read_text(const std::filesystem::path& file, std::size_t most);

/// Throws InputError if a text is UTF-16, as spreadsheets save it as "Unicode text".
void refuse_utf16(const std::filesystem::path& file, std::string_view text);

}  // namespace sonde
