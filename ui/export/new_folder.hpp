// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace sonde::ui {

/// A folder that appears whole or not at all. The caller fills it under another name, in the folder
/// in which it will lie, and then calls commit(). Without that, the destructor removes it with all
/// that it holds.
class NewFolder {
 public:
  /// Makes the folder under its other name. Throws InputError if `folder` exists already, or if it
  /// cannot be made.
  explicit NewFolder(const std::filesystem::path& folder);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// The folder to write into before commit().
  const std::filesystem::path& path() const { return filling_; }
  /// Renames the filled folder to its own name. Throws InputError if that fails.
  void commit();

 private:
  std::filesystem::path folder_, filling_;
};

}  // namespace sonde::ui
