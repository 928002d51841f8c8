// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "engine/devices/device_sample.hpp"
#include "engine/devices/hid_report_descriptor.hpp"

namespace sonde {

/// The usages of devices with sticks.
inline constexpr HidUsage joystick{0x01, 0x04}, game_pad{0x01, 0x05};

/// A number in a report, and its contribution to one of the six deflections.
struct StickSource {
  enum class Kind {
    centred,    ///< rests in the middle of its range, or at zero
    one_way,    ///< rests at the lower end of its range
    hat_right,  ///< a hat's direction; no value of its range: at rest
    hat_up,
  };
  HidField field;
  Kind kind = Kind::centred;
  int axis = 0;     ///< in the order of SixAxes
  double sign = 1;  ///< from the device's frame (x right, y towards the user, z down) to ours
};

/// The sources of a controller's deflections, by its descriptor:
///
/// - X and Y, the first stick, move to the right and away;
/// - of the pairs Z, Rz and Rx, Ry, the one that is first in the report is the second stick, which
/// turns about z and x, and the other one the triggers, which move down and up (as the simulation
/// page's brake and accelerator do);
/// - six axes in the order X, Y, Z, Rx, Ry, Rz, and any remaining axis, have the meaning of their
/// names;
/// - a hat moves up and down and turns about y, if nothing else does.
///
/// Sliders, dials and wheels are not used: they do not spring back, so a probe under rate control
/// would never rest. Empty if fewer than four of the six deflections have a source.
std::vector<StickSource> stick_layout(const HidReportDescriptor& descriptor);

/// Any joystick or game pad with six axes or two sticks, by its report descriptor. Converts reports
/// to samples as SpaceMouse does, in the same frame; no device, no clock.
class StickController {
 public:
  /// Many controllers send nothing while nothing changes; then a deflection is kept. One that was
  /// seen to repeat its reports counts as at rest if it has sent nothing for this time.
  static constexpr DeviceClock::duration stale_after = std::chrono::milliseconds(200);
  /// After this many consecutive refused reports the deflection is zero and the device faulty.
  static constexpr int most_refused = 10;
  /// After this many unchanged reports, the controller is one that repeats its reports.
  static constexpr int enough_repeats = 100;
  /// This many reports without a stick within two seconds: the device does not send what it
  /// describes.
  static constexpr int most_unread = 50;

  explicit StickController(const HidReportDescriptor& descriptor);

  const DeviceCapabilities& capabilities() const { return capabilities_; }
  /// Handles one report as it was read, without trusting it. No allocation.
  Heard accept(std::span<const std::uint8_t> report, DeviceClock::time_point now,
               DeviceSample& sample) noexcept;
  /// Why the last report was refused.
  const char* complaint() const { return complaint_; }

 private:
  Heard refuse(const char* complaint, DeviceSample& sample) noexcept;
  Heard unread(DeviceClock::time_point now, DeviceSample& sample) noexcept;
  bool tells(std::span<const std::uint8_t> report, const StickSource& source) const noexcept;
  bool take(std::span<const std::uint8_t> report) noexcept;

  bool numbered_;
  std::vector<StickSource> sources_;
  std::vector<HidField> buttons_;
  std::vector<double> parts_;  ///< the last contribution of each source
  DeviceCapabilities capabilities_;
  const char* complaint_ = "";
  int refused_ = 0;
  int repeats_ = 0;
  int unread_ = 0;
  DeviceClock::time_point unread_since_{};
};

}  // namespace sonde
