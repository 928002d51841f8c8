// SPDX-License-Identifier: GPL-3.0-or-later
// Others may give the file another name, replace it or remove it while it is read.
#include "engine/platform/readable_file.hpp"

#include <windows.h>

#include <algorithm>
#include <system_error>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, std::error_code error) {
  throw InputError::in(file.string(), error.message());
}

std::error_code last_error() { return {static_cast<int>(GetLastError()), std::system_category()}; }

}  // namespace

struct ReadableFile::Handle {
  HANDLE file = INVALID_HANDLE_VALUE;
  ~Handle() {
    if (file != INVALID_HANDLE_VALUE) CloseHandle(file);
  }
};

ReadableFile::ReadableFile(const std::filesystem::path& file)
    : file_(file), handle_(std::make_unique<Handle>()) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    fail(file_, std::make_error_code(std::errc::is_a_directory));
  constexpr DWORD shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  handle_->file = CreateFileW(file.c_str(), GENERIC_READ, shared, nullptr, OPEN_EXISTING,
                              FILE_ATTRIBUTE_NORMAL, nullptr);
  LARGE_INTEGER size{};
  if (handle_->file == INVALID_HANDLE_VALUE || !GetFileSizeEx(handle_->file, &size))
    fail(file_, last_error());
  size_ = static_cast<std::uint64_t>(size.QuadPart);
}

ReadableFile::~ReadableFile() = default;

std::string ReadableFile::read(std::uint64_t offset, std::size_t most) const {
  constexpr std::size_t most_at_once = 1 << 30;
  const std::uint64_t there = size_ > offset ? size_ - offset : 0;
  std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(most, there)), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    OVERLAPPED place{};
    place.Offset = static_cast<DWORD>(offset + done);
    place.OffsetHigh = static_cast<DWORD>((offset + done) >> 32);
    const auto wanted = static_cast<DWORD>(std::min(bytes.size() - done, most_at_once));
    DWORD n = 0;
    const bool read = ReadFile(handle_->file, bytes.data() + done, wanted, &n, &place);
    if (!read && GetLastError() != ERROR_HANDLE_EOF) fail(file_, last_error());
    if (n == 0) break;
    done += n;
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace sonde
