// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/simulated_response.hpp"

#include <algorithm>

namespace sonde {
namespace {

/// Its friction becomes exact only as its steps become short: at ten a sample, every figure that is
/// identified of the profiles is within 2 % of theirs. Fewer where the delay would be more steps
/// than it can keep.
int steps_a_sample(double delay, double sample_time) {
  constexpr double wanted = 10;
  const double most = static_cast<double>(SimulatedDevice::most_samples_late) * sample_time;
  return static_cast<int>(std::clamp(most / std::max(delay, 1e-9), 1.0, wanted));
}

}  // namespace

Response simulated_response(SimulatedDeviceParameters device, const PulsePlan& plan) {
  for (HandleMotion* motion : {&device.translation, &device.rotation})
    motion->hand_stiffness = motion->hand_damping = 0;
  const int steps = steps_a_sample(device.delay, plan.sample_time);
  SimulatedDevice simulated(device, plan.sample_time / steps);
  simulated.reset(Pose{});
  Response out;
  double samples = 0;
  for (const Wrench& command : commands_of(plan)) {
    out.push_back({samples * plan.sample_time, command, simulated.measured()});
    for (int i = 0; i < steps; ++i) simulated.step(command, Pose{});
    ++samples;
  }
  return out;
}

}  // namespace sonde
