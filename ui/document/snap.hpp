// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde::ui {

/// What is laid onto what.
enum class SnapKind { face, edge, axis };

/// A plane by a point and its outward normal, or a line by a point and its direction, unit.
struct Feature {
  Vec3 at = Vec3::Zero(), along = Vec3::Zero();
};

/// The pose at which a feature of the probe, which it has at X_FM, lies on another, by the least
/// turn about its point and the least move after it: of planes the normals are opposed; lines run
/// either way. All in the fixed body's frame.
Pose snapped(const Pose& X_FM, SnapKind kind, const Feature& own, const Feature& onto);

}  // namespace sonde::ui
