// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "engine/devices/device_sample.hpp"
#include "engine/devices/force_protocol.hpp"

namespace sonde {

/// The host's side of the open force protocol: turns pose reports into samples, and a wrench into a
/// report. It trusts nothing that arrives. No device, no clock.
///
/// It refuses a report, and the device is faulty from that moment (no force), where a number is not
/// finite, the quaternion is not of unit length (by more than 1 %), the handle is outside the
/// working volume, it has moved further from the report before than a hand moves (a tenth of the
/// longest reach, at most 20 mm, and 5 m/s; 0.2 rad and 60 rad/s), or the sequence goes back. The
/// device is ready again after a run of reports that agree with each other. The same holds at the
/// start and after silence.
class ForceDevice {
 public:
  /// Reports in a row that must agree before the device is ready.
  static constexpr int enough_in_a_row = 20;

  explicit ForceDevice(const force_protocol::Limits& limits);

  const DeviceCapabilities& capabilities() const { return capabilities_; }
  /// One report as it was read.
  Heard accept(std::span<const std::uint8_t> report, DeviceClock::time_point now,
               DeviceSample& sample);
  /// The same for a report that was decoded, or that arrived in another way than by HID.
  Heard accept(force_protocol::PoseReport report, DeviceClock::time_point now,
               DeviceSample& sample);
  /// Reports that the data cannot be used: faulty from now on, for this reason.
  Heard refuse(const std::string& complaint, DeviceSample& sample);
  /// Why the last report was refused.
  const std::string& complaint() const { return complaint_; }
  std::uint64_t lost() const { return lost_; }  ///< reports the sequence says are missing

  /// The next wrench report: within the limits, and zero and switched off unless `on`.
  std::array<std::uint8_t, force_protocol::WrenchReport::bytes> wrench_report(
      const DeviceWrench& wrench, bool on);

 private:
  /// Empty where the pose can be true by itself, and then normalised.
  std::string implausible(force_protocol::PoseReport& report) const;
  /// Empty where it can follow the last.
  std::string does_not_follow(const force_protocol::PoseReport& report) const;

  force_protocol::Limits limits_;
  DeviceCapabilities capabilities_;
  DeviceClock::duration stale_after_;
  std::optional<force_protocol::PoseReport> last_;
  DeviceClock::time_point last_heard_{};
  int in_a_row_ = 0;
  std::uint64_t lost_ = 0;
  std::uint16_t next_wrench_ = 0;
  std::string complaint_;
};

}  // namespace sonde
