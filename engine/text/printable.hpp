// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sonde {

/// The text with every control character (C0, and C1 in UTF-8) as \xNN: a file's name may contain
/// any, and a terminal would execute it.
std::string printable(std::string_view text);

/// The same for bytes that may be no text: what a keyboard can type as it is, the others as \xNN.
std::string typeable(std::string_view bytes);

/// UTF-8 as it is, each other byte as \xNN: a file's name may contain any, JSON none of these.
std::string utf8_text(std::string_view bytes);

}  // namespace sonde
