// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/new_folder.hpp"

#include <string>
#include <system_error>

#include "engine/base/error.hpp"
#include "engine/platform/writable_file.hpp"

namespace sonde::ui {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& folder, const std::string& reason) {
  throw InputError::in(folder.string(), "cannot be written: " + reason);
}

/// Without a slash at its end, which would be a name of its own.
fs::path plain(const fs::path& folder) {
  return folder.has_filename() ? folder : folder.parent_path();
}

}  // namespace

NewFolder::NewFolder(const fs::path& folder) : folder_(plain(folder)) {
  std::error_code error;
  if (fs::exists(folder_, error)) fail(folder_, "it is there already");
  std::string hidden = ".";
  hidden.append(folder_.filename().string().substr(0, 200)).append(".part-");
  hidden.append(std::to_string(process_number()));
  filling_ = folder_.parent_path() / hidden;
  if (!fs::create_directory(filling_, error))
    fail(folder_, error ? error.message() : "a folder of an export that is going on is in the way");
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!filling_.empty()) fs::remove_all(filling_, ignored);
}

void NewFolder::commit() {
  std::error_code error;
  fs::rename(filling_, folder_, error);
  if (error) fail(folder_, error.message());
  filling_.clear();
}

}  // namespace sonde::ui
