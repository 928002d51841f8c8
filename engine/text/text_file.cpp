// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

#include "engine/base/error.hpp"
#include "engine/platform/read_stream.hpp"

namespace sonde {

std::string read_text(const std::filesystem::path& file, std::size_t most) {
  const auto fail = [&](const std::string& reason) {
    return InputError::in(file.string(), reason);
  };
  const auto system_reason = [] { return std::generic_category().message(errno); };

  const ReadStream stream = open_to_read(file);
  if (!stream) throw fail(system_reason());
  // Reads piece by piece, not by the file's size: a pipe has none.
  std::string text;
  char piece[65536];
  while (const std::size_t n = std::fread(piece, 1, sizeof piece, stream.get())) {
    text.append(piece, n);
    if (text.size() > most) throw fail("longer than " + std::to_string(most) + " bytes");
  }
  if (std::ferror(stream.get()) != 0) throw fail(system_reason());
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.erase(0, mark.size());
  if (text.empty()) throw fail("the file is empty");
  return text;
}

void refuse_utf16(const std::filesystem::path& file, std::string_view text) {
  const auto has_no_letter = [&](std::size_t i) { return i < text.size() && text[i] == 0; };
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
      (has_no_letter(0) && has_no_letter(2)) || (has_no_letter(1) && has_no_letter(3)))
    throw InputError::in(file.string(), "is UTF-16 text; save it as UTF-8");
}

}  // namespace sonde
