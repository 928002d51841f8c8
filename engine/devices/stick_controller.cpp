// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/stick_controller.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/base/elementary.hpp"
#include "engine/base/ordering.hpp"
#include "engine/devices/hid_controls.hpp"

namespace sonde {
namespace {

using namespace std::chrono_literals;
using Kind = StickSource::Kind;

constexpr std::uint16_t simulation_controls = 0x02;
constexpr std::uint16_t hat_switch = 0x39, accelerator = 0xC4, brake = 0xC5;
constexpr auto unread_within = 2s;
enum Axis { x, y, z, rx, ry, rz };

/// The fields by their usages, the first of each; places are indices in the descriptor.
class Controls {
 public:
  explicit Controls(const HidReportDescriptor& descriptor) : inputs_(descriptor.inputs) {
    for (int axis = x; axis <= rz; ++axis)
      axes_[static_cast<std::size_t>(axis)] =
          find({generic_desktop, static_cast<std::uint16_t>(first_axis + axis)});
    hat_ = find({generic_desktop, hat_switch});
    left_ = find({simulation_controls, brake});
    right_ = find({simulation_controls, accelerator});
  }

  std::vector<StickSource> sources() {
    if (!has(x) || !has(y)) return {};
    add(x, Kind::centred, x, 1);
    add(y, Kind::centred, y, -1);
    if (!in_order()) take_pairs();
    if (left_ && right_ && !drives(z)) take_triggers(*left_, *right_);
    for (const Axis axis : {z, rx, ry, rz})
      if (has(axis) && !used_[axis] && !drives(axis))
        add(axis, Kind::centred, axis, axis == rx ? 1 : -1);
    if (hat_ && !drives(ry)) sources_.push_back({inputs_[*hat_], Kind::hat_right, ry, 1});
    if (hat_ && !drives(z)) sources_.push_back({inputs_[*hat_], Kind::hat_up, z, 1});
    constexpr int fewest = 4;
    int driven = 0;
    for (const Axis axis : {x, y, z, rx, ry, rz}) driven += drives(axis) ? 1 : 0;
    return driven >= fewest ? std::move(sources_) : std::vector<StickSource>{};
  }

 private:
  using Place = std::optional<std::size_t>;

  Place find(HidUsage usage) const {
    // A field with an empty range is useless.
    const auto found = std::ranges::find_if(inputs_, [&](const HidField& field) {
      return field.usage == usage && !field.array && field.bits > 1 &&
             field.logical_max > field.logical_min;
    });
    if (found == inputs_.end()) return {};
    return static_cast<std::size_t>(found - inputs_.begin());
  }

  bool has(Axis axis) const { return axes_[axis].has_value(); }
  std::size_t place(Axis axis) const { return *axes_[axis]; }
  bool drives(Axis axis) const {
    return std::ranges::any_of(sources_, [&](const StickSource& s) { return s.axis == axis; });
  }
  void add(Axis field, Kind kind, Axis axis, double sign) {
    sources_.push_back({inputs_[place(field)], kind, axis, sign});
    used_[field] = true;
  }

  /// All six axes in order: a six-axis controller, not sticks.
  bool in_order() const {
    for (const Axis axis : {x, y, z, rx, ry, rz})
      if (!has(axis) || (axis != x && place(axis) < place(Axis(axis - 1)))) return false;
    return true;
  }

  void take_pairs() {
    struct Pair {
      Axis across, along;
    };
    std::vector<Pair> pairs;
    for (const Pair pair : {Pair{z, rz}, Pair{rx, ry}})
      if (has(pair.across) && has(pair.along)) pairs.push_back(pair);
    ordering::sort(pairs, {}, [&](const Pair& pair) { return place(pair.across); });
    if (pairs.empty()) return;
    // A stick to the right turns to the right, which is negative about an axis that points up.
    add(pairs[0].across, Kind::centred, rz, -1);
    add(pairs[0].along, Kind::centred, rx, 1);
    if (pairs.size() == 1) return;
    take_triggers(place(pairs[1].across), place(pairs[1].along));
    used_[pairs[1].across] = used_[pairs[1].along] = true;
  }

  void take_triggers(std::size_t left, std::size_t right) {
    sources_.push_back({inputs_[left], Kind::one_way, z, -1});
    sources_.push_back({inputs_[right], Kind::one_way, z, 1});
  }

  const std::vector<HidField>& inputs_;
  std::array<Place, 6> axes_;
  std::array<bool, 6> used_{};
  Place hat_, left_, right_;
  std::vector<StickSource> sources_;
};

/// Clockwise from up, in radians; no value at rest.
std::optional<double> direction_of(const HidField& hat, std::int64_t value) {
  if (value < hat.logical_min || value > hat.logical_max) return {};
  const auto steps = static_cast<double>(hat.logical_max - hat.logical_min + 1);
  return 2 * std::numbers::pi * static_cast<double>(value - hat.logical_min) / steps;
}

double part_of(const StickSource& source, std::int64_t value) {
  const HidField& field = source.field;
  switch (source.kind) {
    case Kind::centred:
      return deflection_of(field, value);
    case Kind::one_way:
      return static_cast<double>(value - field.logical_min) /
             static_cast<double>(field.logical_max - field.logical_min);
    case Kind::hat_right:
    case Kind::hat_up: {
      const auto direction = direction_of(field, value);
      if (!direction) return 0;
      return source.kind == Kind::hat_up ? elementary::cos(*direction)
                                         : elementary::sin(*direction);
    }
  }
  return 0;
}

}  // namespace

std::vector<StickSource> stick_layout(const HidReportDescriptor& descriptor) {
  return Controls(descriptor).sources();
}

StickController::StickController(const HidReportDescriptor& descriptor)
    : numbered_(descriptor.numbered()),
      sources_(stick_layout(descriptor)),
      buttons_(button_fields(descriptor)),
      parts_(sources_.size(), 0) {
  capabilities_.buttons = highest_button(buttons_);
}

bool StickController::tells(std::span<const std::uint8_t> report,
                            const StickSource& source) const noexcept {
  return !numbered_ || source.field.report_id == report[0];
}

/// Takes all numbers of the report, or none if one of them is implausible.
bool StickController::take(std::span<const std::uint8_t> report) noexcept {
  constexpr double beyond_belief = 2;
  const auto part = [&](const StickSource& source) -> std::optional<double> {
    const auto value = value_of(source.field, report);
    if (!value) return {};
    const double part = part_of(source, *value);
    return std::abs(part) <= beyond_belief ? std::optional(part) : std::nullopt;
  };
  for (const StickSource& source : sources_)
    if (tells(report, source) && !part(source)) return false;
  for (std::size_t i = 0; i < sources_.size(); ++i)
    if (tells(report, sources_[i]))
      parts_[i] = sources_[i].sign * std::clamp(part(sources_[i]).value_or(0), -1.0, 1.0);
  return true;
}

Heard StickController::accept(std::span<const std::uint8_t> report, DeviceClock::time_point now,
                              DeviceSample& sample) noexcept {
  if (report.empty()) return refuse("it sent an empty report", sample);
  if (std::ranges::none_of(sources_, [&](const StickSource& one) { return tells(report, one); }))
    return unread(now, sample);
  if (!take(report))
    return refuse("it sent a report that is shorter than its descriptor says, or far out of range",
                  sample);
  SixAxes deflection = SixAxes::Zero();
  for (std::size_t i = 0; i < sources_.size(); ++i) deflection[sources_[i].axis] += parts_[i];
  deflection = deflection.cwiseMax(-1).cwiseMin(1);
  std::uint32_t buttons = sample.buttons;
  take_buttons(buttons_, report, buttons);
  const bool again = sample.state == DeviceState::ready && deflection == sample.deflection &&
                     buttons == sample.buttons;
  repeats_ = std::min(repeats_ + (again ? 1 : 0), enough_repeats);
  refused_ = unread_ = 0;
  sample.deflection = deflection;
  sample.buttons = buttons;
  sample.state = DeviceState::ready;
  sample.time = now;
  sample.stale_after =
      repeats_ == enough_repeats ? stale_after : DeviceClock::duration(std::chrono::hours(24));
  ++sample.count;
  return Heard::sample;
}

/// A report without a stick: a battery's level, a touch pad, or a mode that its descriptor omits.
Heard StickController::unread(DeviceClock::time_point now, DeviceSample& sample) noexcept {
  if (unread_ == 0 || now - unread_since_ > unread_within) {
    unread_ = 0;
    unread_since_ = now;
  }
  if (++unread_ < most_unread) return Heard::nothing;
  unread_ = most_unread;
  refused_ = most_refused;
  return refuse("it sends only reports that its descriptor does not explain: connect it by cable",
                sample);
}

Heard StickController::refuse(const char* complaint, DeviceSample& sample) noexcept {
  complaint_ = complaint;
  refused_ = std::min(refused_ + 1, most_refused);
  if (refused_ == most_refused) {
    sample.state = DeviceState::faulty;
    sample.deflection.setZero();
    sample.buttons = 0;
    std::ranges::fill(parts_, 0);
  }
  return Heard::refused;
}

}  // namespace sonde
