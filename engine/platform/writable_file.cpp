// SPDX-License-Identifier: GPL-3.0-or-later
// What holds whatever the handle is.
#include "engine/platform/writable_file.hpp"

#include <utility>

namespace sonde {

WritableFile::~WritableFile() { close(); }

WritableFile::WritableFile(WritableFile&& other) noexcept
    : handle_(std::exchange(other.handle_, none)), error_(other.error_) {}

WritableFile& WritableFile::operator=(WritableFile&& other) noexcept {
  if (this == &other) return *this;
  close();
  handle_ = std::exchange(other.handle_, none);
  error_ = other.error_;
  return *this;
}

bool WritableFile::is_open() const noexcept { return handle_ != none; }

}  // namespace sonde
