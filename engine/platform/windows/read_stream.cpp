// SPDX-License-Identifier: GPL-3.0-or-later
// By wide names: the C library takes narrow ones to be in the user's code page.
#include "engine/platform/read_stream.hpp"

#include <io.h>

#include <cerrno>

namespace sonde {

ReadStream open_to_read(const std::filesystem::path& file) noexcept {
  if (file.native() == L"/dev/stdin") {
    const int copy = _dup(_fileno(stdin));
    return ReadStream(copy < 0 ? nullptr : _fdopen(copy, "rb"));
  }
  // Windows says of a folder that it may not be read.
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    errno = EISDIR;
    return nullptr;
  }
  return ReadStream(_wfopen(file.c_str(), L"rb"));
}

}  // namespace sonde
