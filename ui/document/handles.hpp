// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <functional>
#include <optional>

#include "engine/geometry/pose.hpp"

namespace sonde::ui {

/// Arrows along three axes and rings about them, to move the probe: plain geometry, in the fixed
/// body's mesh frame.
struct Handles {
  Vec3 centre;
  Mat3 axes;          ///< in the columns
  double length = 0;  ///< of an arrow, m; the rings are a little smaller
};
constexpr double ring_part = 0.8;  ///< a ring's radius, of the length
/// Handles around the probe's centre of mass: along the axes of the fixed body's mesh, or the
/// probe's own.
Handles handles_at(const Pose& X_FM, const Vec3& com, bool local, double length);

/// The handle that the user grabbed.
struct Grip {
  bool turns = false;
  Eigen::Index axis = 0;
  Vec3 at = Vec3::Zero();  ///< where, on a ring
};
/// Where a point of the scene is in the view.
using Projection = std::function<QPointF(const Vec3&)>;

/// The nearest handle within a few pixels; none where the cursor is beside all of them.
std::optional<Grip> grip_at(const Handles& handles, const Projection& on_screen, QPointF cursor);

/// The displacement of the handle that follows the cursor: metres along its axis or radians about
/// it. No value where the axis points at the eye.
double follow(const Handles& handles, const Grip& grip, const Projection& on_screen, QPointF by);

}  // namespace sonde::ui
