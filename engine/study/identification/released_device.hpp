// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/hand/simulated_device.hpp"

namespace sonde {

/// A simulated device without a hand. It begins at rest at the origin of its base. Its friction
/// becomes exact only for short steps, so it takes ten steps a sample (fewer if it could not store
/// the commands of its delay).
class ReleasedDevice {
 public:
  /// `sample_time` in s. Allocates. Throws std::invalid_argument as SimulatedDevice does.
  ReleasedDevice(SimulatedDeviceParameters device, double sample_time);

  Pose measured() const noexcept { return device_.measured(); }  ///< X_BH, by its encoders
  /// Advances to the next sample; the motors get `command` (in its base). No allocation, lock, log,
  /// throw.
  void step(const Wrench& command) noexcept;

 private:
  int steps_;  ///< steps in a sample
  SimulatedDevice device_;
};

}  // namespace sonde
