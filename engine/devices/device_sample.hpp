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
  absent,   ///< no such device is connected
  refused,  ///< connected, but it cannot be opened or used: the status gives the reason
  ready,    ///< its reports can be used
  silent,   ///< open, but it sends no reports although it should
  faulty,   ///< its reports cannot be used: the status gives the reason
};
const char* name_of(DeviceState state);

/// The capabilities of a device. They do not change while it stays connected.
struct DeviceCapabilities {
  bool position = false;      ///< reports the position of its handle; false: deflections from rest
  bool force = false;         ///< takes a wrench
  bool led = false;           ///< has a light that can be switched
  unsigned buttons = 0;       ///< number of buttons, as far as it reports them
  double max_force = 0;       ///< N, 0 without force
  double max_torque = 0;      ///< N·m
  double max_stiffness = 0;   ///< N/m, stable by its maker's statement; 0 if unknown
  double max_damping = 0;     ///< N·s/m, virtual, likewise
  double rate_hz = 0;         ///< reports a second by its own statement; 0 if unknown
  Vec3 reach = Vec3::Zero();  ///< half the working volume along each axis, m; 0 without position
};

/// The newest state of a device: plain data, copied through a triple buffer.
struct DeviceSample {
  DeviceState state = DeviceState::absent;
  bool position = false;           ///< it reports poses; false: deflections from rest
  double max_force = 0;            ///< N, its largest force; 0 without force
  double max_torque = 0;           ///< N·m
  double max_stiffness = 0;        ///< N/m, by its maker's statement; 0: unknown
  double max_damping = 0;          ///< N·s/m, likewise
  double rate_hz = 0;              ///< reports a second by its own statement; 0: unknown
  std::uint64_t count = 0;         ///< usable reports since the start
  std::uint32_t session = 0;       ///< changes after each gap: earlier samples are not continuous
  std::uint32_t buttons = 0;       ///< bit 0 is button 1
  DeviceClock::time_point time{};  ///< when the report arrived
  DeviceClock::duration stale_after = std::chrono::milliseconds(200);
  Pose X_BH{};  ///< the handle in the device's base; identity without position
  SixAxes deflection = SixAxes::Zero();  ///< -1 to 1 each; zero if the device reports positions
};

/// The sample as valid at `now`. A sample that is too old has no deflection, and is silent; except
/// for a device of deflections at rest, which then sends nothing. Does not depend on the device's
/// thread.
DeviceSample aged(const DeviceSample& sample, DeviceClock::time_point now) noexcept;

/// Force (N) and torque (N·m, about the handle's point), in the device's base, on the hand.
struct DeviceWrench {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
  DeviceClock::time_point sampled{};  ///< arrival of the sample that it answers; none: unknown
};

/// A wrench that is not renewed is applied for this time.
inline constexpr std::chrono::milliseconds wrench_lasts{50};

/// Force and torque, each scaled down to the device's limits; zero if a number is not finite.
DeviceWrench limited(const DeviceWrench& wrench, const DeviceCapabilities& capabilities) noexcept;

/// The result of a report.
enum class Heard {
  sample,   ///< it changed the sample
  nothing,  ///< it contains nothing of use, and is no fault: a battery's level, a repetition
  refused,  ///< it is implausible
};

}  // namespace sonde
