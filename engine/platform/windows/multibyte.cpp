// SPDX-License-Identifier: GPL-3.0-or-later
// The standard library makes a path of a narrow name by the C library's mbrtowc(), which takes it
// for Latin-1, and a narrow name of a path in UTF-8. Here both are UTF-8: engine/CMakeLists.txt has
// the linker put this one in the other's place.
#include <cerrno>
#include <cstddef>
#include <cwchar>

namespace {

constexpr std::size_t invalid = static_cast<std::size_t>(-1);
constexpr std::size_t incomplete = static_cast<std::size_t>(-2);

std::size_t refuse() {
  errno = EILSEQ;
  return invalid;
}

/// Bytes of the character that begins with this one; 0: none does.
std::size_t size_of(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return 2;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 ? 4 : 0;
}

/// Its number, of so many bytes; -1 where they are none, or a longer form of another.
long character_of(const unsigned char* bytes, std::size_t size) {
  if (size == 1) return bytes[0];
  long value = bytes[0] & (0xff >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if ((bytes[i] & 0xc0) != 0x80) return -1;
    value = value << 6 | (bytes[i] & 0x3f);
  }
  const bool is_half = value >= 0xd800 && value < 0xe000;
  const bool is_long = (size == 3 && value < 0x800) || (size == 4 && value < 0x10000);
  return is_half || is_long || value > 0x10ffff ? -1 : value;
}

/// Of a character of two units, the first is told with three of its four bytes. The state keeps the
/// second for the next call, which takes the fourth.
std::size_t first_half(long value, wchar_t* to, std::mbstate_t* state) {
  *to = static_cast<wchar_t>(0xd800 + ((value - 0x10000) >> 10));
  *state = static_cast<std::mbstate_t>(0xdc00 + (value & 0x3ff));
  return 3;
}

std::size_t second_half(wchar_t* to, std::mbstate_t* state) {
  *to = static_cast<wchar_t>(*state);
  *state = 0;
  return 1;
}

}  // namespace

// The linker's name for it.
extern "C" std::size_t __wrap_mbrtowc(  // NOLINT(bugprone-reserved-identifier)
    wchar_t* to, const char* from, std::size_t most, std::mbstate_t* state) {
  static thread_local std::mbstate_t own{};
  if (!state) state = &own;
  wchar_t unused = 0;
  if (!to) to = &unused;
  if (!from) return static_cast<std::size_t>(*state = 0);
  if (most == 0) return incomplete;
  if (*state != 0) return second_half(to, state);
  const auto* bytes = reinterpret_cast<const unsigned char*>(from);
  const std::size_t size = size_of(bytes[0]);
  if (size == 0) return refuse();
  if (size > most) return incomplete;
  const long value = character_of(bytes, size);
  if (value < 0) return refuse();
  if (value > 0xffff) return first_half(value, to, state);
  *to = static_cast<wchar_t>(value);
  return value == 0 ? 0 : size;
}
