// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/writable_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

namespace sonde {
namespace {

int flags_of(WritableFile::Opening opening) {
  switch (opening) {
    case WritableFile::Opening::anew:
      return O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
    case WritableFile::Opening::append:
      return O_WRONLY | O_APPEND | O_CLOEXEC;
    default:
      return O_WRONLY | O_CLOEXEC;
  }
}

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

WritableFile::WritableFile(const std::filesystem::path& file, Opening opening)
    : handle_(::open(file.c_str(), flags_of(opening), 0666)) {
  noted(is_open());
}

bool WritableFile::noted(bool done) noexcept {
  if (!done && error_ == 0) error_ = errno;
  return done;
}

bool WritableFile::write(std::string_view bytes) {
  return noted(write_all(static_cast<int>(handle_), bytes));
}

bool WritableFile::sync() { return noted(::fsync(static_cast<int>(handle_)) == 0); }

bool WritableFile::lock() {
  // Where a file system has no locks, nobody else holds one.
  return ::flock(static_cast<int>(handle_), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

bool WritableFile::truncate(std::uint64_t size) {
  const int descriptor = static_cast<int>(handle_);
  const auto end = static_cast<off_t>(size);
  return noted(::ftruncate(descriptor, end) == 0 && ::lseek(descriptor, end, SEEK_SET) == end);
}

bool WritableFile::close() {
  if (!is_open()) return error_ == 0;
  return noted(::close(static_cast<int>(std::exchange(handle_, none))) == 0);
}

int replace_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  return std::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

int may_write(const std::filesystem::path& file_or_folder) {
  std::error_code error;
  const int use = std::filesystem::is_directory(file_or_folder, error) ? X_OK : 0;
  return ::access(file_or_folder.c_str(), W_OK | use) == 0 ? 0 : errno;
}

int write_standard_output(std::string_view bytes) {
  return write_all(STDOUT_FILENO, bytes) ? 0 : errno;
}

std::uint64_t process_number() { return static_cast<std::uint64_t>(::getpid()); }

}  // namespace sonde
