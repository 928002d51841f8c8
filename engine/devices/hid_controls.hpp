// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/devices/hid_report_descriptor.hpp"

namespace sonde {

// What pucks and game controllers have in common: axes that spring back, and buttons.

inline constexpr std::uint16_t generic_desktop = 0x01;
/// X; Y, Z, Rx, Ry and Rz follow.
inline constexpr std::uint16_t first_axis = 0x30;

/// 0 at rest, 1 at the end of the range. A range without negative numbers rests in its middle.
double deflection_of(const HidField& axis, std::int64_t value) noexcept;

/// At most as many buttons are told: a bit each.
inline constexpr unsigned most_buttons = 32;
/// Bits, or arrays of the numbers of those held.
std::vector<HidField> button_fields(const HidReportDescriptor& descriptor);
/// Of these fields, at most 32.
unsigned highest_button(std::span<const HidField> fields) noexcept;
/// Sets the buttons that this report tells; the others stay.
void take_buttons(std::span<const HidField> fields, std::span<const std::uint8_t> report,
                  std::uint32_t& buttons) noexcept;

}  // namespace sonde
