// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/writable_file.hpp"

#include <windows.h>
// After windows.h, which it needs.
#include <fcntl.h>
#include <io.h>
#include <share.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace sonde {
namespace {

int flags_of(WritableFile::Opening opening) {
  constexpr int always = _O_WRONLY | _O_BINARY | _O_NOINHERIT;
  switch (opening) {
    case WritableFile::Opening::anew:
      return always | _O_CREAT | _O_EXCL;
    case WritableFile::Opening::append:
      return always | _O_APPEND;
    default:
      return always;
  }
}

bool write_all(int descriptor, std::string_view bytes) {
  constexpr std::size_t most_at_once = 1 << 20;
  while (!bytes.empty()) {
    const auto size = static_cast<unsigned>(std::min(bytes.size(), most_at_once));
    const int n = _write(descriptor, bytes.data(), size);
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

}  // namespace

WritableFile::WritableFile(const std::filesystem::path& file, Opening opening)
    : handle_(_wsopen(file.c_str(), flags_of(opening), _SH_DENYNO, _S_IREAD | _S_IWRITE)) {
  noted(is_open());
}

bool WritableFile::noted(bool done) noexcept {
  if (!done && error_ == 0) error_ = errno != 0 ? errno : EIO;
  return done;
}

bool WritableFile::write(std::string_view bytes) {
  return noted(write_all(static_cast<int>(handle_), bytes));
}

bool WritableFile::sync() { return noted(_commit(static_cast<int>(handle_)) == 0); }

bool WritableFile::lock() {
  const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(static_cast<int>(handle_)));
  OVERLAPPED place{};
  place.OffsetHigh = 0x7fffffff;  // far behind the end: what is locked cannot be read by others
  return LockFileEx(handle, LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &place) ||
         GetLastError() != ERROR_LOCK_VIOLATION;
}

bool WritableFile::truncate(std::uint64_t size) {
  const int descriptor = static_cast<int>(handle_);
  const auto end = static_cast<__int64>(size);
  return noted(_chsize_s(descriptor, end) == 0 && _lseeki64(descriptor, end, SEEK_SET) == end);
}

bool WritableFile::close() {
  if (!is_open()) return error_ == 0;
  return noted(_close(static_cast<int>(std::exchange(handle_, none))) == 0);
}

int replace_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  return error.default_error_condition().value();
}

// Of a folder Windows tells by trying alone.
int may_write(const std::filesystem::path& file_or_folder) {
  constexpr int to_write = 2;
  return _waccess(file_or_folder.c_str(), to_write) == 0 ? 0 : errno;
}

int write_standard_output(std::string_view bytes) {
  return write_all(_fileno(stdout), bytes) ? 0 : errno;
}

std::uint64_t process_number() { return GetCurrentProcessId(); }

}  // namespace sonde
