// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <filesystem>

#include "engine/scene/scene.hpp"

namespace sonde::ui {

/// The files that a scene names outside of its own folder, links followed, and that the user has
/// not agreed to yet for this scene. Sonde's own files may always be named. Reads the scene and
/// nothing that it names. Throws as read_scene does. @p scene is absolute.
QStringList paths_to_ask_for(const std::filesystem::path& scene);
/// The same of the scene that a recording holds. Throws as read_recording does.
QStringList recorded_paths_to_ask_for(const std::filesystem::path& recording);

/// From now on this scene or recording may name these files. Kept with the settings of the window,
/// for the hundred that were agreed to last; an older one is asked about again.
void agree_to_paths(const std::filesystem::path& file, const QStringList& paths);
/// The same for all that a scene names which the user writes to that file.
void agree_to_paths_of(const Scene& scene, const std::filesystem::path& file);

}  // namespace sonde::ui
