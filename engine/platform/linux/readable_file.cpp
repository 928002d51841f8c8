// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/readable_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  throw InputError::in(file.string(), std::generic_category().message(error));
}

}  // namespace

struct ReadableFile::Handle {
  int descriptor = -1;
  ~Handle() {
    if (descriptor >= 0) ::close(descriptor);
  }
};

ReadableFile::ReadableFile(const std::filesystem::path& file)
    : file_(file), handle_(std::make_unique<Handle>()) {
  handle_->descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  struct ::stat status {};
  if (handle_->descriptor < 0 || ::fstat(handle_->descriptor, &status) != 0) fail(file_, errno);
  if (S_ISDIR(status.st_mode)) fail(file_, EISDIR);
  size_ = static_cast<std::uint64_t>(status.st_size);
}

ReadableFile::~ReadableFile() = default;

std::string ReadableFile::read(std::uint64_t offset, std::size_t most) const {
  const std::uint64_t there = size_ > offset ? size_ - offset : 0;
  std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(most, there)), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::pread(handle_->descriptor, bytes.data() + done, bytes.size() - done,
                              static_cast<off_t>(offset + done));
    if (n < 0 && errno != EINTR) fail(file_, errno);
    if (n == 0) break;
    if (n > 0) done += static_cast<std::size_t>(n);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace sonde
