// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/plain_text.hpp"

#include <algorithm>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view padding = "\0\x1a \t\n\v\f\r"sv;

/// UTF-16 without a mark: every second byte is zero, and the others are ASCII.
bool alternates_with_zeros(std::string_view bytes, std::size_t zero) {
  const std::string_view start = bytes.substr(0, 32);
  if (start.size() < 8) return false;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const auto c = static_cast<unsigned char>(start[i]);
    if (i % 2 == zero ? c != 0 : c < '\t' || c > '~') return false;
  }
  return true;
}

const char* other_encoding(std::string_view bytes) {
  if (bytes.starts_with("\xff\xfe\0\0"sv) || bytes.starts_with("\0\0\xfe\xff"sv)) return "UTF-32";
  if (bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("\xfe\xff"sv)) return "UTF-16";
  if (alternates_with_zeros(bytes, 1) || alternates_with_zeros(bytes, 0)) return "UTF-16";
  return nullptr;
}

}  // namespace

std::string_view plain_text(const std::string& file, std::string_view bytes) {
  if (const char* encoding = other_encoding(bytes))
    throw InputError::at_line(file, 1, std::string(encoding) + " text: save it as UTF-8");
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (bytes.starts_with(mark)) bytes.remove_prefix(mark.size());
  return bytes;
}

std::size_t end_marks(std::string_view text) {
  const std::size_t last = text.find_last_not_of(padding);
  const std::size_t start = last == text.npos ? 0 : last + 1;
  const std::size_t mark = text.find_first_of("\0\x1a"sv, start);
  return mark == text.npos ? 0 : text.size() - mark;
}

bool is_padding(std::string_view bytes) { return bytes.find_first_not_of(padding) == bytes.npos; }

}  // namespace sonde
