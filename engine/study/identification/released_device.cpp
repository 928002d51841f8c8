// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/released_device.hpp"

#include <algorithm>

namespace sonde {
namespace {

/// With ten steps a sample, every value identified from the profiles is within 2 % of theirs.
int steps_a_sample(double delay, double sample_time) {
  constexpr double wanted = 10;
  const double most = static_cast<double>(SimulatedDevice::most_samples_late) * sample_time;
  return static_cast<int>(std::clamp(most / std::max(delay, 1e-9), 1.0, wanted));
}

SimulatedDeviceParameters released(SimulatedDeviceParameters device) {
  for (HandleMotion* motion : {&device.translation, &device.rotation})
    motion->hand_stiffness = motion->hand_damping = 0;
  return device;
}

}  // namespace

ReleasedDevice::ReleasedDevice(SimulatedDeviceParameters device, double sample_time)
    : steps_(steps_a_sample(device.delay, sample_time)),
      device_(released(device), sample_time / steps_) {}

void ReleasedDevice::step(const Wrench& command) noexcept {
  for (int i = 0; i < steps_; ++i) device_.step(command, Pose{});
}

}  // namespace sonde
