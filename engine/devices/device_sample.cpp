// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/device_sample.hpp"

namespace sonde {
namespace {

/// Limits the length of any finite vector without overflow of its square.
Vec3 no_longer(const Vec3& v, double most) {
  const double largest = v.cwiseAbs().maxCoeff();
  if (largest == 0) return v;
  const Vec3 scaled = v / largest;
  return largest * scaled.norm() <= most ? v : Vec3(scaled.normalized() * most);
}

}  // namespace

const char* name_of(DeviceState state) {
  switch (state) {
    case DeviceState::absent:
      return "absent";
    case DeviceState::refused:
      return "refused";
    case DeviceState::ready:
      return "ready";
    case DeviceState::silent:
      return "silent";
    case DeviceState::faulty:
      return "faulty";
  }
  return "";
}

DeviceSample aged(const DeviceSample& sample, DeviceClock::time_point now) noexcept {
  DeviceSample aged = sample;
  const bool old = now - sample.time > sample.stale_after;
  const bool at_rest = !sample.position && sample.deflection.isZero(0);
  if (!old || sample.state != DeviceState::ready || at_rest) return aged;
  aged.state = DeviceState::silent;
  aged.deflection.setZero();
  return aged;
}

DeviceWrench limited(const DeviceWrench& wrench, const DeviceCapabilities& capabilities) noexcept {
  if (!wrench.force.allFinite() || !wrench.torque.allFinite()) return {};
  return {no_longer(wrench.force, capabilities.max_force),
          no_longer(wrench.torque, capabilities.max_torque), wrench.sampled};
}

}  // namespace sonde
