// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace sonde::ui {

/// What an arrow key, Page Up or Page Down does to the probe.
struct Nudge {
  /// Whose axes it goes along: the picture's, the fixed body's mesh, or the probe's mesh. Of a
  /// body, left and right are -x and x, down and up -y and y, Page Down and Page Up -z and z.
  enum class Axes { picture, fixed, probe };
  Axes axes = Axes::picture;
  double step = 1e-3;                        ///< m
  double turn = 2 * std::numbers::pi / 180;  ///< rad, with Shift
};

}  // namespace sonde::ui
