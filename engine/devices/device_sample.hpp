// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <cstdint>
#include <string>

#include "engine/geometry/pose.hpp"

namespace sonde {

using DeviceClock = std::chrono::steady_clock;

/// Six numbers in the order x, y, z, about x, about y, about z; right-handed.
using SixAxes = Eigen::Matrix<double, 6, 1>;

enum class DeviceState {
  absent,   ///< nothing of the kind is connected
  refused,  ///< connected, but it cannot be opened or used: the status gives the reason
  ready,    ///< its reports can be used
  silent,   ///< open, but it sends nothing where it should
  faulty,   ///< its reports cannot be used: the status gives the reason
};
const char* name_of(DeviceState state);

/// The capabilities of a device. They do not change while it stays connected.
struct DeviceCapabilities {
  bool position = false;      ///< reports the position of its handle; else deflections from rest
  bool force = false;         ///< takes a wrench
  bool led = false;           ///< has a light to switch
  unsigned buttons = 0;       ///< how many, as far as it says
  double max_force = 0;       ///< N, 0 without force
  double max_torque = 0;      ///< N·m
  double max_stiffness = 0;   ///< N/m that it holds stably by its maker's word; 0 where not known
  double rate_hz = 0;         ///< reports a second by its own word; 0 where not known
  Vec3 reach = Vec3::Zero();  ///< half the working volume along each axis, m; 0 without position
};

/// The newest state of a device: plain data, copied through a triple buffer.
struct DeviceSample {
  DeviceState state = DeviceState::absent;
  bool position = false;           ///< it tells poses; else deflections from rest
  double max_force = 0;            ///< N, what it can give; 0 without force
  double max_torque = 0;           ///< N·m
  double max_stiffness = 0;        ///< N/m that it holds by its maker's word; 0: not known
  std::uint64_t count = 0;         ///< usable reports since the start
  std::uint32_t session = 0;       ///< another after each gap: what came before is no neighbour
  std::uint32_t buttons = 0;       ///< bit 0 is button 1
  DeviceClock::time_point time{};  ///< when the report arrived
  DeviceClock::duration stale_after = std::chrono::milliseconds(200);
  Pose X_BH{};  ///< the handle in the device's base; identity without position
  SixAxes deflection = SixAxes::Zero();  ///< -1 to 1 each; zero where the device tells positions
};

/// The sample as it counts at `now`. One that is too old has no deflection, and is silent; except a
/// device of deflections at rest, which sends nothing then. Does not rely on the device's thread.
DeviceSample aged(const DeviceSample& sample, DeviceClock::time_point now) noexcept;

/// Force (N) and torque (N·m, about the handle's point), in the device's base, on the hand.
struct DeviceWrench {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  DeviceClock::time_point sampled{};  ///< when the sample that it answers arrived; none: not known
};

/// A wrench that nobody renews is applied for so long.
inline constexpr std::chrono::milliseconds wrench_lasts{50};

/// Force and torque, each scaled down to the device's limits; zero where a number is not finite.
DeviceWrench limited(const DeviceWrench& wrench, const DeviceCapabilities& capabilities) noexcept;

/// The result of a report.
enum class Heard {
  sample,   ///< it changed the sample
  nothing,  ///< it holds nothing of use, and is no fault: a battery's level, a repeat
  refused,  ///< it cannot be true
};

}  // namespace sonde
