// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/hid_controls.hpp"

#include <algorithm>

namespace sonde {
namespace {

constexpr std::uint16_t button_page = 0x09;

std::uint32_t bit_of(std::int64_t button) {
  return button >= 1 && button <= most_buttons ? 1U << (button - 1) : 0U;
}

}  // namespace

double deflection_of(const HidField& axis, std::int64_t value) noexcept {
  const bool centred = axis.logical_min < 0;
  const auto low = static_cast<double>(axis.logical_min);
  const auto high = static_cast<double>(axis.logical_max);
  const double rest = centred ? 0 : (low + high) / 2;
  const double range = centred ? std::max(-low, high) : (high - low) / 2;
  return (static_cast<double>(value) - rest) / range;
}

std::vector<HidField> button_fields(const HidReportDescriptor& descriptor) {
  std::vector<HidField> fields;
  std::ranges::copy_if(descriptor.inputs, std::back_inserter(fields),
                       [](const HidField& field) { return field.usage.page == button_page; });
  return fields;
}

unsigned highest_button(std::span<const HidField> fields) noexcept {
  std::int64_t highest = 0;
  for (const HidField& field : fields) {
    const std::int64_t last =
        field.array ? field.usage.id + field.logical_max - field.logical_min : field.usage.id;
    highest = std::max(highest, last);
  }
  return static_cast<unsigned>(std::min<std::int64_t>(highest, most_buttons));
}

void take_buttons(std::span<const HidField> fields, std::span<const std::uint8_t> report,
                  std::uint32_t& buttons) noexcept {
  std::uint32_t told = 0, held = 0;
  for (const HidField& field : fields) {
    const auto value = value_of(field, report);
    if (!value) continue;
    if (!field.array) {
      told |= bit_of(field.usage.id);
      if (*value != 0) held |= bit_of(field.usage.id);
      continue;
    }
    told = ~0U;
    if (*value >= field.logical_min && *value <= field.logical_max)
      held |= bit_of(field.usage.id + *value - field.logical_min);
  }
  buttons = (buttons & ~told) | held;
}

}  // namespace sonde
