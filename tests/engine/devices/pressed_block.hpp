// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "engine/devices/device_hand.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "tests/engine/devices/over_hid.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {

/// The whole way from a device to the force in it: its library or node, the thread that reads it,
/// its hand, the servo and the geometry in their real threads. A box hangs 1 mm above a block; the
/// device's axes are those of the scene, one to one.
class PressedBlock {
 public:
  static Pose at_depth(double depth) { return {Quat::Identity(), Vec3(0, 0, 0.075 - depth)}; }
  /// No time in a test: a busy machine may stop any thread for as long as it likes.
  static ServoSettings settings() {
    ServoSettings settings;
    settings.safety.stalled_after = 1e9;
    settings.safety.ramp_time = 0.05;
    return settings;
  }

  explicit PressedBlock(const DeviceChoice& choice, const ServoSettings& wanted = settings())
      : device(std::make_shared<InputDevice>(choice)),
        hand(device, in_the_scene(), Vec3::Zero(), at_depth(-0.001)),
        servo({body(box({0.02, 0.03, 0.05})), body(box({0.3, 0.3, 0.1}))}, Method::pdg, Coupling{},
              wanted) {
    servo.start(at_depth(-0.001), hand.hand());
  }
  ~PressedBlock() { servo.stop(); }
  PressedBlock(const PressedBlock&) = delete;
  PressedBlock& operator=(const PressedBlock&) = delete;

  /// The newest tick; before the first, an empty one.
  Snapshot now() {
    const Snapshot* newest = servo.latest();
    return newest ? *newest : Snapshot{};
  }
  Withheld withheld() { return now().hand.withheld; }

  std::shared_ptr<InputDevice> device;
  DeviceHand hand;
  Servo servo;

 private:
  static DeviceSettings in_the_scene() {
    DeviceSettings settings;
    settings.frame = DeviceSettings::Frame::scene;
    settings.smoothing = 0;
    return settings;
  }
};

}  // namespace sonde::test
