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

/// The host's side of the open force protocol: converts pose reports to samples, and a wrench to a
/// report. It trusts no incoming data. No device, no clock.
///
/// It refuses a report, and the device is faulty from that moment (no force), if a number is not
/// finite, the quaternion is not of unit length (by more than 1 %), the handle is outside the
/// working volume, it has moved further since the last report than a hand moves (a tenth of the
/// longest reach, at most 20 mm, and 5 m/s; 0.2 rad and 60 rad/s), or the sequence goes back. The
/// device is ready again after a run of consistent reports. The same holds at the start and after
/// silence.
class ForceDevice {
 public:
  /// Number of consecutive consistent reports before the device is ready.
  static constexpr int enough_in_a_row = 20;

  explicit ForceDevice(const force_protocol::Limits& limits);

  const DeviceCapabilities& capabilities() const { return capabilities_; }
  /// Handles one report as it was read.
  Heard accept(std::span<const std::uint8_t> report, DeviceClock::time_point now,
               DeviceSample& sample);
  /// The same for a decoded report, or one that did not arrive by HID.
  Heard accept(force_protocol::PoseReport report, DeviceClock::time_point now,
               DeviceSample& sample);
  /// Reports that the data cannot be used: the device is faulty from now on, for this reason.
  Heard refuse(const std::string& complaint, DeviceSample& sample);
  /// Why the last report was refused.
  const std::string& complaint() const { return complaint_; }
  std::uint64_t lost() const {
    return lost_;
  }  ///< reports that are missing according to the sequence

  /// The next wrench report: within the limits; zero and switched off unless `on`.
  std::array<std::uint8_t, force_protocol::WrenchReport::bytes> wrench_report(
      const DeviceWrench& wrench, bool on);

 private:
  /// Checks a pose by itself and normalises it. Empty if it is plausible.
  std::string implausible(force_protocol::PoseReport& report) const;
  /// Checks a pose against the last one. Empty if it is plausible.
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
