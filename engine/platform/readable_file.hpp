// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace sonde {

/// A file that is read at any place, and stays readable while it is held, whatever becomes of its
/// name. Throws InputError naming the file and the reason, from each function.
class ReadableFile {
 public:
  explicit ReadableFile(const std::filesystem::path& file);
  ~ReadableFile();
  ReadableFile(const ReadableFile&) = delete;
  ReadableFile& operator=(const ReadableFile&) = delete;

  std::uint64_t size() const noexcept { return size_; }  ///< bytes, when it was opened
  const std::filesystem::path& path() const noexcept { return file_; }
  /// The bytes from `offset` on: as many as there are, `most` at most.
  std::string read(std::uint64_t offset, std::size_t most) const;

 private:
  struct Handle;
  std::filesystem::path file_;
  std::unique_ptr<Handle> handle_;
  std::uint64_t size_ = 0;
};

}  // namespace sonde
