// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <numbers>
#include <optional>

#include "engine/geometry/pose.hpp"

namespace sonde::ui {

struct ViewAxes;

/// Where a body was clicked on in the view.
struct PickedFace {
  QString of;  ///< the body, or its part, in words
  bool on_probe = false;
  Vec3 normal = Vec3::UnitZ();  ///< out of it, unit, in the body's mesh frame
};

/// What an arrow key, Page Up or Page Down does to the probe.
struct Nudge {
  /// Whose axes it goes along: the picture's, those of the fixed body's mesh or of the probe's, the
  /// normal of a face and two lines in it, or the scene's. Of a body and of the scene, left and
  /// right are -x and x, down and up -y and y, Page Down and Page Up -z and z. Page Up goes out of
  /// a face.
  enum class Axes { picture, fixed, probe, face, world };
  Axes axes = Axes::picture;
  double step = 1e-3;                        ///< m
  double turn = 2 * std::numbers::pi / 180;  ///< rad, with Shift
  std::optional<PickedFace> face = {};       ///< the one clicked last
  Quat q_FW = Quat::Identity();              ///< the scene's axes in the fixed body's mesh frame
};

/// Right, up, and to where Page Up goes, in the columns; in the fixed body's mesh frame. In the
/// picture Page Up goes away from the eye. In a face, right is along the axis of its body that is
/// the nearest to right in the picture, so that the steps are the same from wherever one looks.
/// None: along a face, and none was clicked.
std::optional<Mat3> nudge_axes(const Nudge& nudge, const Pose& X_FM, const ViewAxes& view);

}  // namespace sonde::ui
