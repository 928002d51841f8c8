// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/output_file.hpp"

#include <atomic>
#include <cerrno>
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
  WritableFile special(file, WritableFile::Opening::existing);
  if (!special.is_open() || !special.write(text)) fail(file, special.error());
}

/// A name next to the target that no other process and no other thread uses.
fs::path temporary_name(const fs::path& target) {
  static std::atomic<unsigned> count{0};
  std::string name = ".";
  name.append(target.filename().string().substr(0, 200)).append(".part-");
  name.append(std::to_string(process_number())).append("-").append(std::to_string(count++));
  return folder_of(target) / name;
}

/// Writes a new file down to the disk. The number of an error, 0 where all went well.
int write_new(const fs::path& file, std::string_view text) {
  WritableFile fresh(file, WritableFile::Opening::anew);
  if (fresh.is_open() && fresh.write(text) && fresh.sync()) fresh.close();
  return fresh.error();
}

/// One that goes leaves no trace, and no complaint.
void remove_quietly(const fs::path& file) {
  std::error_code gone;
  fs::remove(file, gone);
}

}  // namespace

void check_writable(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) fail(file, EISDIR);
  if (is_special(file)) return;
  const fs::path target = behind_links(file);
  if (const int reason = may_write(folder_of(target)); reason != 0) fail(file, reason);
  // A file that may not be written stays, although its folder would allow to replace it.
  if (!fs::exists(target, error)) return;
  if (const int reason = may_write(target); reason != 0) fail(file, reason);
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
    remove_quietly(temporary);
    fail(file, error);
  }
  temporary_ = temporary;
}

PendingFile::~PendingFile() {
  if (!temporary_.empty()) remove_quietly(temporary_);
}

void PendingFile::commit() {
  if (temporary_.empty()) return;
  if (const int error = replace_file(temporary_, target_); error != 0) fail(file_, error);
  temporary_.clear();
}

void write_whole(const fs::path& file, std::string_view text) { PendingFile(file, text).commit(); }

WritableFile create_anew(const fs::path& file) {
  check_writable(file);
  if (is_special(file)) {
    WritableFile special(file, WritableFile::Opening::existing);
    if (!special.is_open()) fail(file, special.error());
    return special;
  }
  const fs::path target = behind_links(file);
  const fs::path temporary = temporary_name(target);
  WritableFile fresh(temporary, WritableFile::Opening::anew);
  if (!fresh.is_open()) fail(file, fresh.error());
  const int error = replace_file(temporary, target);
  if (error == 0) return fresh;
  fresh.close();
  remove_quietly(temporary);
  fail(file, error);
}

}  // namespace sonde
