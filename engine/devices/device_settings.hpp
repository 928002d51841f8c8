// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/devices/axis_map.hpp"

namespace sonde {

/// The user's settings of how a device moves the probe: plain data, copied through a triple buffer.
/// Stored for each device.
struct DeviceSettings {
  /// The meaning of a deflection. A device that reports positions is always followed in position.
  enum class Control { position, rate };
  /// The axes along which the device's x (right), y (away from the user) and z (up) lie.
  enum class Frame {
    view,   ///< those of the picture, however the camera stands
    scene,  ///< x, y and z of the scene
    y_up,   ///< x, -z and y of the scene: for scenes whose y points up
  };

  Control control = Control::rate;
  Frame frame = Frame::view;
  double scaling = 1;       ///< how far the probe moves per movement of the device
  double reach = 0.1;       ///< m or m/s of full deflection
  double turn = 1;          ///< rad or rad/s of full deflection
  double smoothing = 0.03;  ///< s, time constant for deflections
  int clutch_button = 1;    ///< held down, it keeps the probe in place; 0: none
  AxisMap axes;
  // What the device wants of the haptic loop, before what the scene says; none: as the scene says.
  std::optional<double> rate_hz;
  std::optional<bool> passivity_control;
};

}  // namespace sonde
