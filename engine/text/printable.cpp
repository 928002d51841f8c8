// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/printable.hpp"

#include <algorithm>
#include <cstddef>

namespace sonde {
namespace {

std::string escape(unsigned char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  return {'\\', 'x', digits[c >> 4U], digits[c & 0xfU]};
}

bool is_control(unsigned char c) { return c < 0x20 || c == 0x7f; }

/// The second byte of U+0080 to U+009F, whose first one is 0xC2.
bool is_control(unsigned char before, unsigned char c) {
  return before == 0xc2 && c >= 0x80 && c < 0xa0;
}

bool is_between(unsigned char c, unsigned char low, unsigned char high) {
  return c >= low && c <= high;
}

/// How many bytes the character of UTF-8 has that the text begins with; 0 where it begins with none
/// (Unicode, table 3-7: neither overlong, nor a surrogate, nor beyond U+10FFFF).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
  };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  if (!is_between(first, 0xc2, 0xf4)) return 0;
  const unsigned char low = first == 0xe0   ? 0xa0
                            : first == 0xf0 ? 0x90
                                            : 0x80,
                      high = first == 0xed   ? 0x9f
                             : first == 0xf4 ? 0x8f
                                             : 0xbf;
  if (!is_between(byte(1), low, high)) return 0;
  const std::size_t length = first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  for (std::size_t i = 2; i < length; ++i)
    if (!is_between(byte(i), 0x80, 0xbf)) return 0;
  return length;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  unsigned char before = 0;
  for (const char letter : text) {
    const auto c = static_cast<unsigned char>(letter);
    if (is_control(before, c)) out.pop_back();  // 0xC2, which is no character by itself
    if (is_control(c) || is_control(before, c))
      out += escape(c);
    else
      out.push_back(letter);
    before = c;
  }
  return out;
}

std::string typeable(std::string_view bytes) {
  std::string out;
  for (const char c : bytes)
    out += c >= ' ' && c <= '~' ? std::string(1, c) : escape(static_cast<unsigned char>(c));
  return out;
}

std::string utf8_text(std::string_view bytes) {
  std::string out;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t length = utf8_length(bytes.substr(i));
    if (length == 0)
      out += escape(static_cast<unsigned char>(bytes[i]));
    else
      out += bytes.substr(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return out;
}

}  // namespace sonde
