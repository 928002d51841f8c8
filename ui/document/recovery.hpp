// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QLockFile>
#include <QString>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/document/document.hpp"
#include "ui/document/loaded_scene.hpp"

namespace sonde::ui {

/// The copy of an open document that is kept in case the program does not come to save it.
struct Recovered {
  Scene scene;
  std::string saved_text;  ///< Document::saved_text
  Pose here;
  std::optional<CameraPlace> camera;
  QDateTime when;
};
std::string recovery_text(const Recovered& recovered);
/// Throws InputError.
Recovered recovered_from(const std::filesystem::path& file);

/// A file with the open document, in a folder that all running programs share. A program that ends
/// normally removes it; a program that is killed leaves it for the next.
class Recovery {
 public:
  explicit Recovery(std::filesystem::path folder);
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// Writes in a thread. False while it still writes the last copy, or if it cannot write.
  bool keep(const Recovered& recovered);
  /// The same, but waits for the end; false where it failed.
  bool keep_now(const Recovered& recovered);
  /// Removes the copy: there is nothing to keep.
  void clear();
  /// The copy stays for the next program, as it does where this one is killed.
  void leave();
  /// The files of programs that have died, the newest first.
  std::vector<std::filesystem::path> left_over() const;
  /// Removes a file that was recovered, or is not wanted.
  static void remove(const std::filesystem::path& file);
  /// Renames a file that cannot be read, perhaps only by this version: it gets the ending .bad, and
  /// stays.
  static void set_aside(const std::filesystem::path& file);

 private:
  std::filesystem::path folder_, file_;
  std::unique_ptr<QLockFile> lock_;  ///< held as long as the file is ours
  std::future<bool> writing_;
};

/// The folder of these files.
std::filesystem::path recovery_folder();

}  // namespace sonde::ui
