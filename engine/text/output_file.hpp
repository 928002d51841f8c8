// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "engine/platform/writable_file.hpp"

namespace sonde {

/// Writes a file whole or not at all: to a temporary file next to it, which is then renamed. The
/// old file stays until that moment. A target that is not a regular file (a pipe, /dev/null) is
/// written directly. Throws InputError naming the file and the reason.
void write_whole(const std::filesystem::path& file, std::string_view text);

/// The same in two steps: the constructor writes the temporary file (or the pipe), and commit()
/// renames it. Without commit() nothing is left.
class PendingFile {
 public:
  PendingFile(const std::filesystem::path& file, std::string_view text);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  void commit();

 private:
  std::filesystem::path file_, target_, temporary_;  // the last is empty if there is none
};

/// Throws what write_whole would throw for a missing or write-protected folder: call it before the
/// work whose result is written.
void check_writable(const std::filesystem::path& file);

/// Opens a new file that takes this name at once, empty; what had the name stays readable to those
/// who have it open. A target that is not an ordinary file is opened as it is. Throws InputError.
WritableFile create_anew(const std::filesystem::path& file);

}  // namespace sonde
