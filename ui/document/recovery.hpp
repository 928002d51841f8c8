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

/// What is kept of a document while it is open, in case the program does not come to save it.
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

/// A file of what is open, in a folder where all running programs have theirs, gone when the
/// program ends as it should. Who is killed leaves it to the next.
class Recovery {
 public:
  explicit Recovery(std::filesystem::path folder);
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// Writes in a thread; false while it still writes the last one, or cannot write at all.
  bool keep(const Recovered& recovered);
  /// The same, to its end; false where that failed.
  bool keep_now(const Recovered& recovered);
  /// There is nothing to be kept any more.
  void clear();
  /// Files of programs that have died, the newest first.
  std::vector<std::filesystem::path> left_over() const;
  /// One that was taken over, or is not wanted.
  static void remove(const std::filesystem::path& file);
  /// One that cannot be read, perhaps by this version: it gets the ending .bad, and stays.
  static void set_aside(const std::filesystem::path& file);

 private:
  std::filesystem::path folder_, file_;
  std::unique_ptr<QLockFile> lock_;  ///< held as long as the file is ours
  std::future<bool> writing_;
};

/// Where the program keeps them.
std::filesystem::path recovery_folder();

}  // namespace sonde::ui
