// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/writable_file.hpp"

#include <cerrno>
#include <cstdio>
#include <random>
#include <system_error>
#include <utility>

namespace sonde {
namespace {

std::FILE* stream(std::intptr_t handle) { return reinterpret_cast<std::FILE*>(handle); }

const char* mode_of(WritableFile::Opening opening) {
  switch (opening) {
    case WritableFile::Opening::anew:
      return "wbx";
    case WritableFile::Opening::append:
      return "ab";
    default:
      return "r+b";
  }
}

int number_of(const std::error_code& error) { return error.default_error_condition().value(); }

}  // namespace

WritableFile::WritableFile(const std::filesystem::path& file, Opening opening) {
  std::FILE* const opened = std::fopen(file.string().c_str(), mode_of(opening));
  if (!noted(opened != nullptr)) return;
  std::setvbuf(opened, nullptr, _IONBF, 0);  // what is written is the system's at once
  handle_ = reinterpret_cast<std::intptr_t>(opened);
}

bool WritableFile::noted(bool done) noexcept {
  if (!done && error_ == 0) error_ = errno != 0 ? errno : EIO;
  return done;
}

bool WritableFile::write(std::string_view bytes) {
  return noted(std::fwrite(bytes.data(), 1, bytes.size(), stream(handle_)) == bytes.size());
}

bool WritableFile::sync() { return noted(std::fflush(stream(handle_)) == 0); }

bool WritableFile::lock() { return true; }

// The standard library cuts files that are closed alone: what is too much stays. Readers of a
// recording stop at its last whole block.
bool WritableFile::truncate(std::uint64_t) { return false; }

bool WritableFile::close() {
  if (!is_open()) return error_ == 0;
  return noted(std::fclose(stream(std::exchange(handle_, none))) == 0);
}

int replace_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  return number_of(error);
}

int may_write(const std::filesystem::path& file_or_folder) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file_or_folder, error);
  if (!std::filesystem::exists(status)) return ENOENT;
  const bool writable =
      (status.permissions() & std::filesystem::perms::owner_write) != std::filesystem::perms::none;
  return writable ? 0 : EACCES;
}

int write_standard_output(std::string_view bytes) {
  const bool done = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() &&
                    std::fflush(stdout) == 0;
  return done ? 0 : errno;
}

std::uint64_t process_number() {
  static const std::uint64_t number = std::random_device()();
  return number;
}

}  // namespace sonde
