// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <utility>

#include "ui/opening.hpp"

class QWidget;

namespace sonde::ui {

/// Every question the window asks and every complaint it makes, so that tests and command lines can
/// answer in a person's place.
struct Prompts {
  std::function<void(const QString& reason)> report_error;
  /// The unit of two meshes in metres; none: given up.
  std::function<std::optional<double>(const MeshPair& pair)> ask_unit;
  std::function<QString()> ask_scene;                                      ///< empty: given up
  std::function<std::optional<std::pair<QString, QString>>()> ask_meshes;  ///< probe and fixed
  std::function<QString()> ask_path;           ///< a recorded path to read; empty: given up
  std::function<QString()> ask_picture;        ///< a file to write; empty: given up
  std::function<QString()> ask_tuning;         ///< a folder to read; empty: given up
  std::function<QString()> ask_tuning_folder;  ///< a folder to write to; empty: given up
};

/// Answers by dialogs over a window.
Prompts dialogs(QWidget& window);

}  // namespace sonde::ui
