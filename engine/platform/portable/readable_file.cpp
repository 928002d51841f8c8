// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/readable_file.hpp"

#include <algorithm>
#include <fstream>
#include <mutex>
#include <system_error>

#include "engine/base/error.hpp"

namespace sonde {

struct ReadableFile::Handle {
  std::mutex mutex;  // a stream has one place
  std::ifstream stream;
};

ReadableFile::ReadableFile(const std::filesystem::path& file)
    : file_(file), handle_(std::make_unique<Handle>()) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError::in(file.string(), std::make_error_code(std::errc::is_a_directory).message());
  handle_->stream.open(file, std::ios::binary);
  if (handle_->stream) size_ = std::filesystem::file_size(file, error);
  if (!handle_->stream || error)
    throw InputError::in(file.string(), error ? error.message() : "cannot be read");
}

ReadableFile::~ReadableFile() = default;

std::string ReadableFile::read(std::uint64_t offset, std::size_t most) const {
  const std::uint64_t there = size_ > offset ? size_ - offset : 0;
  std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(most, there)), '\0');
  const std::lock_guard lock(handle_->mutex);
  handle_->stream.clear();
  handle_->stream.seekg(static_cast<std::streamoff>(offset));
  handle_->stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (handle_->stream.bad()) throw InputError::in(file_.string(), "cannot be read");
  bytes.resize(static_cast<std::size_t>(handle_->stream.gcount()));
  return bytes;
}

}  // namespace sonde
