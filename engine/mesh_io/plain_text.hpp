// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sonde {

/// The bytes of a text file without the mark that some programs begin UTF-8 with. Throws InputError
/// where the text is of another encoding, which no reader can make words of.
std::string_view plain_text(const std::string& file, std::string_view bytes);

/// How many bytes at the end hold no text: NUL and Ctrl-Z (0x1a), with which some programs fill up
/// or end a file, and the blanks among them.
std::size_t end_marks(std::string_view text);

/// True where the bytes say nothing: end marks and blanks.
bool is_padding(std::string_view bytes);

}  // namespace sonde
