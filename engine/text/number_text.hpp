// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace sonde {

/// A number as text, with '.' in any locale. `digits` significant digits (17 are read back to the
/// bit); 0: the shortest text that is read back to the bit.
inline std::string number_text(double value, int digits = 0) {
  char text[64];
  const auto end = digits > 0 ? std::to_chars(text, text + sizeof text, value,
                                              std::chars_format::general, digits)
                              : std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

/// What a number is that no double holds, of which std::from_chars says no more than that: 0 where
/// it is too small, infinite where it is too large.
double out_of_range_number(std::string_view text);

/// The number that the whole text represents, with '.' in any locale; a leading '+' is accepted.
/// One that is too small for a double is 0. No value if the text is anything else, or too large.
inline std::optional<double> parse_number(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end.ptr != text.data() + text.size()) return std::nullopt;
  if (end.ec == std::errc::result_out_of_range && out_of_range_number(text) == 0) return 0;
  return end.ec == std::errc{} ? std::optional(value) : std::nullopt;
}

}  // namespace sonde
