// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, int error) {
  throw InputError::in(file.string(),
                       "cannot be written: " + std::generic_category().message(error));
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// The target of a symbolic link, since the link itself must stay.
fs::path behind_links(const fs::path& file) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  return error ? file : real;
}

bool is_special(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void write_special(const fs::path& file, std::string_view text) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(file, errno);
  const int error = write_all(descriptor, text) ? 0 : errno;
  ::close(descriptor);
  if (error != 0) fail(file, error);
}

/// A name next to the target that no other process and no other thread uses.
fs::path temporary_name(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  std::string name = ".";
  name.append(target.filename().string().substr(0, 200)).append(".part-");
  name.append(std::to_string(::getpid())).append("-").append(std::to_string(count++));
  return folder_of(target) / name;
}

/// Writes a new file and syncs it to disk. Returns an errno; 0 on success.
int write_new(const fs::path& file, std::string_view text) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return errno;
  // Without the sync, a crash of the machine could leave an empty file under the new name.
  int error = write_all(descriptor, text) && ::fsync(descriptor) == 0 ? 0 : errno;
  if (::close(descriptor) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

void check_writable(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) fail(file, EISDIR);
  if (is_special(file)) return;
  const fs::path target = behind_links(file);
  if (::access(folder_of(target).c_str(), W_OK | X_OK) != 0) fail(file, errno);
  // A write-protected file is kept, even if its folder would permit replacing it.
  if (fs::exists(target, error) && ::access(target.c_str(), W_OK) != 0) fail(file, errno);
}

PendingFile::PendingFile(const fs::path& file, std::string_view text) : file_(file) {
  check_writable(file);
  if (is_special(file)) {
    write_special(file, text);
    return;
  }
  target_ = behind_links(file);
  const fs::path temporary = temporary_name(target_);
  if (const int error = write_new(temporary, text); error != 0) {
    ::unlink(temporary.c_str());
    fail(file, error);
  }
  temporary_ = temporary;
}

PendingFile::~PendingFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void PendingFile::commit() {
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(file_, errno);
  temporary_.clear();
}

void write_whole(const fs::path& file, std::string_view text) { PendingFile(file, text).commit(); }

int create_anew(const fs::path& file) {
  check_writable(file);
  if (is_special(file)) {
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(file, errno);
    return descriptor;
  }
  const fs::path target = behind_links(file);
  const fs::path temporary = temporary_name(target);
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(file, errno);
  if (std::rename(temporary.c_str(), target.c_str()) == 0) return descriptor;
  const int error = errno;
  ::close(descriptor);
  ::unlink(temporary.c_str());
  fail(file, error);
}

}  // namespace sonde
