// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace sonde {

/// A file that is open for writing; closed with the object. After a failure error() is its number
/// (std::generic_category says it in words).
class WritableFile {
 public:
  enum class Opening {
    anew,      ///< there must be none of that name
    existing,  ///< what is there: a pipe, a terminal
    append     ///< behind what is there
  };
  WritableFile() = default;
  WritableFile(const std::filesystem::path& file, Opening opening);
  ~WritableFile();
  WritableFile(WritableFile&& other) noexcept;
  WritableFile& operator=(WritableFile&& other) noexcept;

  bool is_open() const noexcept;
  /// 0 where nothing has failed.
  int error() const noexcept { return error_; }
  /// Writes all of it. False where that fails, maybe after a part.
  bool write(std::string_view bytes);
  /// Returns once the disk has what was written. Without that a crash of the machine could leave a
  /// new name on an empty file.
  bool sync();
  /// True if no other process holds the file; from then on this one does, until it is closed. The
  /// portable source cannot tell, and says true.
  bool lock();
  /// Removes what lies beyond that size, bytes; the next write goes there.
  bool truncate(std::uint64_t size);
  bool close();

 private:
  bool noted(bool done) noexcept;
  std::intptr_t handle_ = none;
  int error_ = 0;
  static constexpr std::intptr_t none = -1;
};

/// Gives a file another name; a file that has it already is replaced in one step. 0, or the number
/// of the error: Windows refuses (EACCES) while the other file is open.
int replace_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// 0 where this process may write the file, or in the folder; else the number of the error.
int may_write(const std::filesystem::path& file_or_folder);

/// Writes all of it to the standard output. 0, or the number of the error.
int write_standard_output(std::string_view bytes);

/// A number that no other process has now that writes to the same folders.
std::uint64_t process_number();

}  // namespace sonde
