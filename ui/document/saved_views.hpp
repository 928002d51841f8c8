// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "ui/document/loaded_scene.hpp"

namespace sonde::ui {

/// A place to look from that is kept with a scene, in the fixed body's mesh frame, metres.
struct SavedView {
  QString name;
  CameraPlace place;
};

/// Those of a scene: `saved` in its `view`, in the world frame and the scene's unit.
std::vector<SavedView> saved_views(const Scene& scene);
/// The scene's `view` with these instead; all else in it stays.
std::string view_with(const Scene& scene, const std::vector<SavedView>& views);

}  // namespace sonde::ui
