// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/printable.hpp"

namespace sonde {
namespace {

bool is_control(unsigned char c) { return c < 0x20 || c == 0x7f; }

/// The second byte of U+0080 to U+009F, whose first one is 0xC2.
bool is_control(unsigned char before, unsigned char c) {
  return before == 0xc2 && c >= 0x80 && c < 0xa0;
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string out;
  unsigned char before = 0;
  for (const char letter : text) {
    const auto c = static_cast<unsigned char>(letter);
    if (is_control(before, c)) out.pop_back();  // 0xC2, which is no character by itself
    if (is_control(c) || is_control(before, c))
      out.append("\\x").append({digits[c >> 4U], digits[c & 0xfU]});
    else
      out.push_back(letter);
    before = c;
  }
  return out;
}

}  // namespace sonde
