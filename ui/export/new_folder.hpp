// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace sonde::ui {

/// A folder that appears whole or not at all: it is filled under another name beside its own, and
/// goes with whatever is in it unless it is kept.
class NewFolder {
 public:
  /// Throws InputError where the folder is there already, or cannot be made.
  explicit NewFolder(const std::filesystem::path& folder);
  ~NewFolder();
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;

  /// Where to write for now.
  const std::filesystem::path& path() const { return filling_; }
  /// Gives it its name. Throws InputError.
  void keep();

 private:
  std::filesystem::path folder_, filling_;
};

}  // namespace sonde::ui
