// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/devices/device_sample.hpp"
#include "engine/devices/hid_report_descriptor.hpp"

namespace sonde {

/// The model's name; null if it is not known as a six-axis device of 3Dconnexion.
const char* space_mouse_name(std::uint16_t vendor, std::uint16_t product);

/// 3Dconnexion's mice and keyboards, which have no six axes and are never opened.
bool is_plain_3dconnexion(std::uint16_t vendor, std::uint16_t product);

/// The usage of the interface that reports the axes, among several of a receiver.
inline constexpr HidUsage multi_axis_controller{0x01, 0x08};

/// The positions of the six numbers, the buttons and the light in the reports.
struct SpaceMouseLayout {
  /// From the descriptor, in the device's own frame; none if it does not name all six.
  std::optional<std::array<HidField, 6>> axes;
  std::vector<HidField> buttons;  ///< bits, or arrays of the numbers of the pressed buttons
  unsigned button_count = 0;      ///< at most 32
  std::optional<HidField> led;    ///< an output
};
SpaceMouseLayout space_mouse_layout(const HidReportDescriptor& descriptor);

/// The SpaceMouse family: six deflections of a puck that springs back, buttons, and a light.
/// Converts reports to samples; no device, no clock.
///
/// Axes: x to the right, y away from the user, z up (the device's own frame turned by half a turn
/// about x). Deflections are fractions of the descriptor's range, or of ±350 if it has none. A
/// number up to twice the range is clamped; beyond that, the report is refused and the last
/// deflection is kept. If the descriptor does not name six axes, or a report does not have the
/// stated length, the two known layouts are tried: 7 bytes with id 1 (translation) and id 2
/// (rotation), or 13 bytes with id 1 (both).
class SpaceMouse {
 public:
  /// A puck that is held still repeats its report, so one that sends nothing for this time counts
  /// as at rest, or gone. (Wireless ones report at about 62 Hz.)
  static constexpr DeviceClock::duration stale_after = std::chrono::milliseconds(200);
  /// After this many consecutive refused reports the deflection is zero and the device faulty.
  static constexpr int most_refused = 10;

  explicit SpaceMouse(const HidReportDescriptor& descriptor);

  const DeviceCapabilities& capabilities() const { return capabilities_; }
  /// Handles one report as it was read, without trusting it. No allocation.
  Heard accept(std::span<const std::uint8_t> report, DeviceClock::time_point now,
               DeviceSample& sample) noexcept;
  /// Why the last report was refused.
  const char* complaint() const { return complaint_; }
  /// The output report that switches the light; empty if there is none.
  std::vector<std::uint8_t> led_report(bool on) const;

 private:
  Heard refuse(const char* complaint, DeviceSample& sample) noexcept;
  bool as_described(std::span<const std::uint8_t> report) const noexcept;

  HidReportDescriptor descriptor_;
  SpaceMouseLayout layout_;
  DeviceCapabilities capabilities_;
  const char* complaint_ = "";
  int refused_ = 0;
};

}  // namespace sonde
