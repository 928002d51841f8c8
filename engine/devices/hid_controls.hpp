// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/devices/hid_report_descriptor.hpp"

namespace sonde {

// Common code of pucks and game controllers: axes that spring back, and buttons.

inline constexpr std::uint16_t generic_desktop = 0x01;
/// X; Y, Z, Rx, Ry and Rz follow.
inline constexpr std::uint16_t first_axis = 0x30;

/// 0 at rest, 1 at the end of the range. A range without negative numbers has its rest in the
/// middle.
double deflection_of(const HidField& axis, std::int64_t value) noexcept;

/// Maximum number of buttons: one bit each.
inline constexpr unsigned most_buttons = 32;
/// Bits, or arrays of the numbers of the pressed buttons.
std::vector<HidField> button_fields(const HidReportDescriptor& descriptor);
/// The highest button of these fields, at most 32.
unsigned highest_button(std::span<const HidField> fields) noexcept;
/// Sets the buttons that this report contains; the others stay.
void take_buttons(std::span<const HidField> fields, std::span<const std::uint8_t> report,
                  std::uint32_t& buttons) noexcept;

}  // namespace sonde
