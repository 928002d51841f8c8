// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/space_mouse.hpp"

#include <algorithm>
#include <cmath>

#include "engine/devices/hid_controls.hpp"

namespace sonde {
namespace {

constexpr std::uint16_t logitech = 0x046d, connexion = 0x256f;

struct Model {
  std::uint16_t vendor, product;
  const char* name;
};
constexpr Model models[] = {
    {logitech, 0xc603, "SpaceMouse Plus XT"},
    {logitech, 0xc605, "CADman"},
    {logitech, 0xc606, "SpaceMouse Classic"},
    {logitech, 0xc621, "Spaceball 5000"},
    {logitech, 0xc623, "SpaceTraveler"},
    {logitech, 0xc625, "SpacePilot"},
    {logitech, 0xc626, "SpaceNavigator"},
    {logitech, 0xc627, "SpaceExplorer"},
    {logitech, 0xc628, "SpaceNavigator for Notebooks"},
    {logitech, 0xc629, "SpacePilot Pro"},
    {logitech, 0xc62b, "SpaceMouse Pro"},
    {logitech, 0xc640, "NuLOOQ"},
    {connexion, 0xc62e, "SpaceMouse Wireless (cable)"},
    {connexion, 0xc62f, "SpaceMouse Wireless (receiver)"},
    {connexion, 0xc631, "SpaceMouse Pro Wireless (cable)"},
    {connexion, 0xc632, "SpaceMouse Pro Wireless (receiver)"},
    {connexion, 0xc633, "SpaceMouse Enterprise"},
    {connexion, 0xc635, "SpaceMouse Compact"},
    {connexion, 0xc636, "SpaceMouse Module"},
    {connexion, 0xc638, "SpaceMouse Pro Wireless BT"},
    {connexion, 0xc63a, "SpaceMouse Wireless BT"},
    {connexion, 0xc652, "Universal Receiver"},
};
constexpr std::uint16_t plain[] = {0xc650, 0xc651, 0xc654, 0xc655, 0xc656,
                                   0xc657, 0xc658, 0xc664, 0xc665, 0xc668};

constexpr std::uint16_t leds = 0x08;
constexpr std::uint16_t generic_indicator = 0x4B;
constexpr std::int64_t usual_range = 350;
constexpr std::size_t short_report = 7, long_report = 13;
constexpr std::uint8_t translation_id = 1, rotation_id = 2, buttons_id = 3, led_id = 4,
                       battery_id = 0x17;

/// A signed 16-bit number, as in both known layouts.
HidField word(std::uint8_t id, std::uint32_t place) {
  return {.report_id = id,
          .bit = 8 + 16 * place,
          .bits = 16,
          .logical_min = -usual_range,
          .logical_max = usual_range};
}

std::array<HidField, 6> split_layout() {
  return {word(translation_id, 0), word(translation_id, 1), word(translation_id, 2),
          word(rotation_id, 0),    word(rotation_id, 1),    word(rotation_id, 2)};
}

std::array<HidField, 6> joint_layout() {
  std::array<HidField, 6> axes;
  for (std::uint32_t i = 0; i < 6; ++i) axes[i] = word(translation_id, i);
  return axes;
}

/// An empty range in a descriptor is wrong and is replaced.
HidField with_range(HidField axis) {
  if (axis.logical_max > axis.logical_min) return axis;
  axis.logical_min = -usual_range;
  axis.logical_max = usual_range;
  return axis;
}

std::optional<std::array<HidField, 6>> axes_of(const HidReportDescriptor& descriptor) {
  std::array<HidField, 6> axes;
  for (std::uint16_t i = 0; i < 6; ++i) {
    const HidUsage wanted{generic_desktop, static_cast<std::uint16_t>(first_axis + i)};
    const auto found = std::ranges::find_if(descriptor.inputs, [&](const HidField& field) {
      return field.usage == wanted && !field.array && field.bits > 1;
    });
    if (found == descriptor.inputs.end()) return {};
    axes[i] = with_range(*found);
  }
  return axes;
}

/// Takes the axes that this report contains; returns false if one of them is implausible.
bool take_axes(std::span<const HidField> axes, std::span<const std::uint8_t> report,
               SixAxes& deflection) {
  constexpr double beyond_belief = 2;
  SixAxes taken = deflection;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i].report_id != 0 && axes[i].report_id != report[0]) continue;
    const auto value = value_of(axes[i], report);
    if (!value) return false;
    const double part = deflection_of(axes[i], *value);
    if (std::abs(part) > beyond_belief) return false;
    // The device's y points towards the user and its z down.
    const double sign = i % 3 == 0 ? 1 : -1;
    taken[static_cast<Eigen::Index>(i)] = sign * std::clamp(part, -1.0, 1.0);
  }
  deflection = taken;
  return true;
}

/// The bits after the id, as all known models without a better description send them.
std::uint32_t known_buttons(std::span<const std::uint8_t> report) {
  std::uint32_t buttons = 0;
  for (std::size_t i = 1; i < report.size() && i <= 4; ++i)
    buttons |= std::uint32_t{report[i]} << (8 * (i - 1));
  return buttons;
}

/// Takes the report if it has one of the known layouts; returns whether it does.
bool take_known(std::span<const std::uint8_t> report, DeviceSample& sample) {
  if (report[0] == translation_id && report.size() == long_report)
    return take_axes(joint_layout(), report, sample.deflection);
  if ((report[0] == translation_id || report[0] == rotation_id) && report.size() == short_report)
    return take_axes(split_layout(), report, sample.deflection);
  if (report[0] != buttons_id || report.size() < 2) return false;
  sample.buttons = known_buttons(report);
  return true;
}

}  // namespace

const char* space_mouse_name(std::uint16_t vendor, std::uint16_t product) {
  for (const Model& model : models)
    if (model.vendor == vendor && model.product == product) return model.name;
  return nullptr;
}

bool is_plain_3dconnexion(std::uint16_t vendor, std::uint16_t product) {
  return vendor == connexion && std::ranges::find(plain, product) != std::end(plain);
}

SpaceMouseLayout space_mouse_layout(const HidReportDescriptor& descriptor) {
  SpaceMouseLayout layout{
      .axes = axes_of(descriptor), .buttons = button_fields(descriptor), .led = {}};
  layout.button_count = highest_button(layout.buttons);
  for (const HidField& field : descriptor.outputs)
    if (field.usage == HidUsage{leds, generic_indicator} && !layout.led) layout.led = field;
  if (!layout.axes && !layout.led)
    layout.led = HidField{.report_id = led_id, .bit = 8, .bits = 1, .logical_max = 1};
  return layout;
}

SpaceMouse::SpaceMouse(const HidReportDescriptor& descriptor)
    : descriptor_(descriptor), layout_(space_mouse_layout(descriptor)) {
  capabilities_.led = layout_.led.has_value();
  capabilities_.buttons = layout_.button_count;
}

bool SpaceMouse::as_described(std::span<const std::uint8_t> report) const noexcept {
  const std::uint8_t id = descriptor_.numbered() ? report[0] : std::uint8_t{0};
  const HidReport* described = descriptor_.report(HidReportKind::input, id);
  return layout_.axes && described && described->bytes() == report.size();
}

Heard SpaceMouse::accept(std::span<const std::uint8_t> report, DeviceClock::time_point now,
                         DeviceSample& sample) noexcept {
  if (report.empty()) return refuse("it sent an empty report", sample);
  if (as_described(report)) {
    if (!take_axes(*layout_.axes, report, sample.deflection))
      return refuse("it sent a deflection far out of its range", sample);
    take_buttons(layout_.buttons, report, sample.buttons);
  } else if (report[0] == battery_id) {
    return Heard::nothing;
  } else if (!take_known(report, sample)) {
    return refuse("it sent a report that is neither what its descriptor says nor known", sample);
  }
  refused_ = 0;
  sample.state = DeviceState::ready;
  sample.time = now;
  sample.stale_after = stale_after;
  ++sample.count;
  return Heard::sample;
}

Heard SpaceMouse::refuse(const char* complaint, DeviceSample& sample) noexcept {
  complaint_ = complaint;
  refused_ = std::min(refused_ + 1, most_refused);
  if (refused_ == most_refused) {
    sample.state = DeviceState::faulty;
    sample.deflection.setZero();
    sample.buttons = 0;
  }
  return Heard::refused;
}

std::vector<std::uint8_t> SpaceMouse::led_report(bool on) const {
  if (!layout_.led) return {};
  const HidField& led = *layout_.led;
  const HidReport* described = descriptor_.report(HidReportKind::output, led.report_id);
  // hidapi expects an id before the report, zero if the device has none.
  const std::uint32_t bit = led.bit + (led.report_id == 0 ? 8 : 0);
  const std::size_t bytes = described ? described->bytes() + (led.report_id == 0 ? 1 : 0) : 2;
  std::vector<std::uint8_t> report(bytes);
  report[0] = led.report_id;
  if (on) report.at(bit / 8) |= static_cast<std::uint8_t>(1U << (bit % 8));
  return report;
}

}  // namespace sonde
