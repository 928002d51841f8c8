// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <filesystem>

namespace sonde::ui {

/// The files that a scene names outside of its own folder, links followed, and that the user has
/// not agreed to yet for this scene. Sonde's own scenes may name all of Sonde's own files. Reads
/// the scene and nothing that it names. Throws as read_scene does. @p scene is absolute.
QStringList paths_to_ask_for(const std::filesystem::path& scene);

/// From now on this scene may name these files. Kept with the settings of the window, for the
/// hundred scenes that were agreed to last; an older one is asked about again.
void agree_to_paths(const std::filesystem::path& scene, const QStringList& paths);

}  // namespace sonde::ui
