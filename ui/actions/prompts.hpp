// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <utility>

#include "ui/document/loaded_scene.hpp"

class QWidget;

namespace sonde::ui {

enum class Leaving { save, discard, stay };
enum class Recovering { open, discard, later };
enum class Role {
  probe,
  fixed,
  parts,  ///< further parts of the fixed body
  pair    ///< two meshes: another probe and fixed body
};
enum class Consent { refused, once, kept };

/// Every question and every error message of the window, so that tests and command lines can answer
/// in the user's place.
struct Prompts {
  std::function<void(const QString& reason)> report_error;
  /// Asks for what two mesh files do not state, beginning with a guess; none: cancelled.
  std::function<std::optional<PairSetup>(const MeshPair& pair, const PairSetup& guess)> ask_bodies;
  std::function<Leaving(const QString& name)> ask_leaving;  ///< of a scene that is not saved
  std::function<QString(const QString& first)> ask_save;    ///< a scene to write; empty: given up
  /// Asks whether to read a changed file again, and to lose unsaved changes.
  std::function<bool(const QString& file)> ask_reload;
  /// Whether to save over what another program has written there since it was read.
  std::function<bool(const QString& file)> ask_overwrite;
  std::function<Recovering(const QString& what)> ask_recover;
  /// Asks whether a scene may name these files outside of its folder.
  std::function<Consent(const QString& scene, const QStringList& paths)> ask_paths;
  /// A file that goes with the one that was chosen, and is there already.
  std::function<bool(const QString& file)> ask_replace;
  /// Asks what to use so many meshes for, one or more; none: cancelled.
  std::function<std::optional<Role>(const QString& name, int meshes)> ask_role;
  std::function<QString()> ask_scene;  ///< empty: given up
  /// Probe and fixed body, of which one may be known.
  std::function<std::optional<std::pair<QString, QString>>(const QString& first)> ask_meshes;
  std::function<QStringList()> ask_parts;  ///< meshes to add to the fixed body; empty: given up
  /// A colour, "#e97d25", with one to begin with; empty: given up.
  std::function<QString(const QString& first)> ask_colour;
  std::function<QString()> ask_recording;      ///< a recording to open; empty: given up
  std::function<QString()> ask_record;         ///< a recording to write; empty: given up
  std::function<QString()> ask_path;           ///< a recorded path to read; empty: given up
  std::function<QString()> ask_picture;        ///< a file to write; empty: given up
  std::function<QString()> ask_tuning;         ///< a folder to read; empty: given up
  std::function<QString()> ask_tuning_folder;  ///< a folder to write to; empty: given up
  /// A device profile to write, with a file to begin with; empty: given up.
  std::function<QString(const QString& first)> ask_profile;
};

/// Answers by dialogs over a window.
Prompts dialogs(QWidget& window);

}  // namespace sonde::ui
