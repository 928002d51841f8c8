// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/devices/axis_map.hpp"

namespace sonde {

/// The user's settings for the motion of the probe by a device: plain data, copied through a triple
/// buffer. Stored for each device.
struct DeviceSettings {
  /// The meaning of a deflection. A device that reports positions is always followed in position.
  enum class Control { position, rate };
  /// The frame of the device's axes x (right), y (away from the user) and z (up).
  enum class Frame {
    view,   ///< the picture's, for any camera position
    scene,  ///< x, y and z of the scene
    y_up,   ///< x, -z and y of the scene: for scenes whose y points up
  };

  Control control = Control::rate;
  Frame frame = Frame::view;
  double scaling = 1;       ///< probe displacement per device displacement
  double reach = 0.1;       ///< m or m/s at full deflection
  double turn = 1;          ///< rad or rad/s at full deflection
  double smoothing = 0.03;  ///< s, time constant for deflections
  int clutch_button = 1;    ///< keeps the probe in place while pressed; 0: none
  AxisMap axes;
  // Settings of the haptic loop that override the scene's; none: as in the scene.
  std::optional<double> rate_hz;
  std::optional<bool> passivity_control;
};

}  // namespace sonde
