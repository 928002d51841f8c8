// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/hand/simulated_device.hpp"

namespace sonde {

/// A simulated device that nobody holds: its hand is left out. It begins at rest at the origin of
/// its base. Its friction becomes exact only as its steps become short, so that it takes ten in a
/// sample (fewer where the delay would be more than it can keep).
class ReleasedDevice {
 public:
  /// `sample_time` in s. Allocates. Throws std::invalid_argument as SimulatedDevice.
  ReleasedDevice(SimulatedDeviceParameters device, double sample_time);

  Pose measured() const noexcept { return device_.measured(); }  ///< X_BH, by its encoders
  /// To the next sample; the motors get `command` (in its base). No allocation, lock, log, throw.
  void step(const Wrench& command) noexcept;

 private:
  int steps_;  ///< a sample
  SimulatedDevice device_;
};

}  // namespace sonde
