// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/printable.hpp"

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

}  // namespace sonde
