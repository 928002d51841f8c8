// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "engine/devices/device_sample.hpp"
#include "engine/devices/hid_report_descriptor.hpp"

/// The open protocol of self-built force devices, version 1; its specification is
/// resources/docs/develop/force-device-protocol.md. Both directions are implemented, since the
/// tests simulate the device's side. Numbers are little-endian and SI, float 32 unless they are
/// integers.
namespace sonde::force_protocol {

inline constexpr std::uint8_t version_major = 1, version_minor = 0;
inline constexpr HidUsage usage{0xFF53, 0x06};
inline constexpr std::uint8_t pose_id = 1, wrench_id = 2, limits_id = 3;

/// Report 1, from the device.
struct PoseReport {
  static constexpr std::size_t bytes = 38;
  std::uint16_t sequence = 0;  ///< increases by one; 65535 is followed by 0
  std::uint32_t time_us = 0;   ///< the device's clock at the measurement; wraps
  std::uint16_t buttons = 0;
  bool valid = true;   ///< the pose is measured, not estimated: homed, tracked
  bool fault = false;  ///< the device has switched its force off for its own reason
  Pose X_BH;           ///< the quaternion as sent, not yet normalised
};

/// Report 2, to the device.
struct WrenchReport {
  static constexpr std::size_t bytes = 30;
  std::uint16_t sequence = 0;
  std::uint16_t answers = 0;  ///< sequence of the last received pose
  bool on = false;            ///< false: no force, whatever the other numbers are
  DeviceWrench wrench;
};

/// Report 3, a feature: the properties of the device.
struct Limits {
  static constexpr std::size_t bytes = 34;
  std::uint8_t major = version_major, minor = version_minor;
  std::uint16_t rate_hz = 1000;  ///< pose reports a second
  double max_force = 0;          ///< N
  double max_torque = 0;         ///< N·m
  Vec3 reach = Vec3::Zero();     ///< half the working volume, m, about the base's origin
  double max_stiffness = 0;      ///< N/m; 0: unknown
  std::uint8_t buttons = 0;
};

std::array<std::uint8_t, PoseReport::bytes> encode(const PoseReport& report);
std::array<std::uint8_t, WrenchReport::bytes> encode(const WrenchReport& report);
std::array<std::uint8_t, Limits::bytes> encode(const Limits& limits);

/// No value if the id or the mark is not that of the report, or bytes are missing. Additional bytes
/// belong to a later minor version, and are ignored. Values are as sent, including NaN.
std::optional<PoseReport> decode_pose(std::span<const std::uint8_t> report);
std::optional<WrenchReport> decode_wrench(std::span<const std::uint8_t> report);
std::optional<Limits> decode_limits(std::span<const std::uint8_t> report);

/// The fault of the limits; empty if they are usable.
std::string fault_of(const Limits& limits);
/// What the descriptor lacks; empty if it has the three reports.
std::string fault_of(const HidReportDescriptor& descriptor);

/// The report descriptor of version 1, as a firmware sends it.
std::span<const std::uint8_t> report_descriptor();

}  // namespace sonde::force_protocol
