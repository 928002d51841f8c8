// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/force_protocol.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace sonde::force_protocol {
namespace {

constexpr std::array<std::uint8_t, 4> mark{'S', '6', 'D', 'F'};
constexpr std::uint8_t valid_flag = 1, fault_flag = 2;  // of a pose
constexpr std::uint8_t on_flag = 1;                     // of a wrench

/// Appends numbers.
class Writer {
 public:
  explicit Writer(std::span<std::uint8_t> bytes) : bytes_(bytes) {}
  Writer& u8(std::uint8_t value) {
    bytes_[at_++] = value;
    return *this;
  }
  Writer& u16(std::uint16_t value) {
    return u8(static_cast<std::uint8_t>(value)).u8(static_cast<std::uint8_t>(value >> 8));
  }
  Writer& u32(std::uint32_t value) {
    return u16(static_cast<std::uint16_t>(value)).u16(static_cast<std::uint16_t>(value >> 16));
  }
  Writer& real(double value) {
    return u32(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  Writer& vector(const Vec3& v) { return real(v.x()).real(v.y()).real(v.z()); }

 private:
  std::span<std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// Reads numbers; the caller has checked that there are enough bytes.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint8_t u8() { return bytes_[at_++]; }
  std::uint16_t u16() {
    const unsigned low = u8(), high = u8();
    return static_cast<std::uint16_t>(low | (high << 8));
  }
  std::uint32_t u32() {
    const std::uint32_t low = u16(), high = u16();
    return low | (high << 16);
  }
  double real() { return static_cast<double>(std::bit_cast<float>(u32())); }
  Vec3 vector() {
    const double x = real(), y = real(), z = real();
    return {x, y, z};
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

bool is_report(std::span<const std::uint8_t> report, std::uint8_t id, std::size_t bytes) {
  return report.size() >= bytes && report[0] == id;
}

bool in_range(double value, double low, double high) { return value >= low && value <= high; }

std::string version_text(const Limits& limits) {
  return std::to_string(limits.major) + "." + std::to_string(limits.minor);
}

}  // namespace

std::array<std::uint8_t, PoseReport::bytes> encode(const PoseReport& report) {
  std::array<std::uint8_t, PoseReport::bytes> bytes{};
  const int flags = (report.valid ? valid_flag : 0) | (report.fault ? fault_flag : 0);
  Writer(bytes)
      .u8(pose_id)
      .u16(report.sequence)
      .u32(report.time_us)
      .u16(report.buttons)
      .u8(static_cast<std::uint8_t>(flags))
      .vector(report.X_BH.p)
      .real(report.X_BH.q.w())
      .vector(report.X_BH.q.vec());
  return bytes;
}

std::array<std::uint8_t, WrenchReport::bytes> encode(const WrenchReport& report) {
  std::array<std::uint8_t, WrenchReport::bytes> bytes{};
  Writer(bytes)
      .u8(wrench_id)
      .u16(report.sequence)
      .u16(report.answers)
      .u8(report.on ? on_flag : std::uint8_t{0})
      .vector(report.wrench.force)
      .vector(report.wrench.torque);
  return bytes;
}

std::array<std::uint8_t, Limits::bytes> encode(const Limits& limits) {
  std::array<std::uint8_t, Limits::bytes> bytes{};
  Writer writer(bytes);
  writer.u8(limits_id);
  for (const std::uint8_t letter : mark) writer.u8(letter);
  writer.u8(limits.major)
      .u8(limits.minor)
      .u16(limits.rate_hz)
      .real(limits.max_force)
      .real(limits.max_torque)
      .vector(limits.reach)
      .real(limits.max_stiffness)
      .u8(limits.buttons);
  return bytes;
}

std::optional<PoseReport> decode_pose(std::span<const std::uint8_t> report) {
  if (!is_report(report, pose_id, PoseReport::bytes)) return {};
  Reader reader(report.subspan(1));
  PoseReport pose;
  pose.sequence = reader.u16();
  pose.time_us = reader.u32();
  pose.buttons = reader.u16();
  const std::uint8_t flags = reader.u8();
  pose.valid = (flags & valid_flag) != 0;
  pose.fault = (flags & fault_flag) != 0;
  pose.X_BH.p = reader.vector();
  pose.X_BH.q.w() = reader.real();
  pose.X_BH.q.vec() = reader.vector();
  return pose;
}

std::optional<WrenchReport> decode_wrench(std::span<const std::uint8_t> report) {
  if (!is_report(report, wrench_id, WrenchReport::bytes)) return {};
  Reader reader(report.subspan(1));
  WrenchReport wrench;
  wrench.sequence = reader.u16();
  wrench.answers = reader.u16();
  wrench.on = (reader.u8() & on_flag) != 0;
  wrench.wrench.force = reader.vector();
  wrench.wrench.torque = reader.vector();
  return wrench;
}

std::optional<Limits> decode_limits(std::span<const std::uint8_t> report) {
  if (!is_report(report, limits_id, Limits::bytes)) return {};
  if (!std::equal(mark.begin(), mark.end(), report.begin() + 1)) return {};
  Reader reader(report.subspan(1 + mark.size()));
  Limits limits;
  limits.major = reader.u8();
  limits.minor = reader.u8();
  limits.rate_hz = reader.u16();
  limits.max_force = reader.real();
  limits.max_torque = reader.real();
  limits.reach = reader.vector();
  limits.max_stiffness = reader.real();
  limits.buttons = reader.u8();
  return limits;
}

std::string fault_of(const Limits& limits) {
  if (limits.major != version_major)
    return "it speaks version " + version_text(limits) + " of the protocol, Sonde version " +
           std::to_string(version_major);
  // Far beyond what a hand should meet: such limits result from wrong units or bytes.
  constexpr double most_force = 200, most_torque = 50, most_reach = 5, most_stiffness = 1e6;
  if (!in_range(limits.max_force, 0, most_force)) return "its largest force is not 0 to 200 N";
  if (!in_range(limits.max_torque, 0, most_torque)) return "its largest torque is not 0 to 50 N·m";
  for (const double half : limits.reach)
    if (!in_range(half, 0.001, most_reach)) return "its working volume is not 1 mm to 5 m";
  if (!in_range(limits.max_stiffness, 0, most_stiffness))
    return "its largest stiffness is not 0 to 1e6 N/m";
  if (!in_range(limits.rate_hz, 10, 8000)) return "its rate is not 10 to 8000 Hz";
  return "";
}

std::string fault_of(const HidReportDescriptor& descriptor) {
  struct Needed {
    HidReportKind kind;
    std::uint8_t id;
    std::size_t bytes;
    const char* name;
  };
  constexpr Needed needed[] = {
      {HidReportKind::input, pose_id, PoseReport::bytes, "pose report (input 1, 38 bytes)"},
      {HidReportKind::output, wrench_id, WrenchReport::bytes, "wrench report (output 2, 30 bytes)"},
      {HidReportKind::feature, limits_id, Limits::bytes, "limits report (feature 3, 34 bytes)"},
  };
  if (!descriptor.whole) return "its report descriptor is malformed";
  for (const Needed& report : needed) {
    const HidReport* found = descriptor.report(report.kind, report.id);
    if (!found || found->bytes() < report.bytes)
      return std::string("its report descriptor has no ") + report.name;
  }
  return "";
}

std::span<const std::uint8_t> report_descriptor() {
  static constexpr std::uint8_t bytes[] = {
      0x06, 0x53, 0xFF,                                // usage page: vendor-defined FF53
      0x09, 0x06,                                      // usage 6
      0xA1, 0x01,                                      // collection: application
      0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08,        //   bytes, 0 to 255
      0x85, 0x01, 0x09, 0x10, 0x95, 0x25, 0x81, 0x02,  //   report 1, input: 37 bytes after the id
      0x85, 0x02, 0x09, 0x20, 0x95, 0x1D, 0x91, 0x02,  //   report 2, output: 29 bytes
      0x85, 0x03, 0x09, 0x30, 0x95, 0x21, 0xB1, 0x02,  //   report 3, feature: 33 bytes
      0xC0,                                            // end of the collection
  };
  return bytes;
}

}  // namespace sonde::force_protocol
