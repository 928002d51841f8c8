// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace sonde {

/// A number as text, '.' whatever the locale. `digits` significant ones (17 read back as the same
/// number, to the bit); 0: the shortest text that does.
inline std::string number_text(double value, int digits = 0) {
  char text[64];
  const auto end = digits > 0 ? std::to_chars(text, text + sizeof text, value,
                                              std::chars_format::general, digits)
                              : std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

/// The number that is the whole of the text, '.' whatever the locale; a leading '+' is accepted. No
/// value where the text is anything else, or too large for a double.
inline std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end.ec != std::errc{} || end.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace sonde
