// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/simulated_response.hpp"

#include "engine/study/identification/released_device.hpp"

namespace sonde {

Response simulated_response(const SimulatedDeviceParameters& device, const PulsePlan& plan) {
  ReleasedDevice released(device, plan.sample_time);
  Response out;
  double samples = 0;
  for (const Wrench& command : commands_of(plan)) {
    out.push_back({samples * plan.sample_time, command, released.measured()});
    released.step(command);
    ++samples;
  }
  return out;
}

}  // namespace sonde
