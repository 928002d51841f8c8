// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/hand_grip.hpp"

#include <QSettings>
#include <QString>
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "engine/study/tuning/tuning.hpp"

namespace sonde::ui {
namespace {

constexpr SimulatedGrip usual;

/// From a hand that all but lets go to an arm that is braced; a damping below 0.1 N·s/m and a mass
/// above 2 kg are no hand's.
constexpr std::array<Setting, 3> settings{
    {{"hand_stiffness", "Stiffness", "N/m", 20, 5000, usual.stiffness, true,
      "The spring from the handle to where the mouse is."},
     {"hand_damping", "Damping", "N·s/m", 0.1, 100, usual.damping, true,
      "What calms the handle: a firm hand has more."},
     {"hand_mass", "Mass", "kg", 0, 2, usual.mass, false,
      "Moves with the handle. Studies leave it out, since it would help."}}};

constexpr SimulatedGrip of(const HandGrip& hand) { return {hand.stiffness, hand.damping, 0}; }

constexpr std::array<NamedGrip, 3> grips{
    {{"light", of(hand_grips[0]), "Two fingers: a study's light hand, in which walls buzz first."},
     {"usual", usual, "Between the two."},
     {"firm", of(hand_grips[1]), "The whole fist: a study's firm hand."}}};

double SimulatedGrip::*value_of(std::string_view key) {
  if (key == settings[0].key) return &SimulatedGrip::stiffness;
  if (key == settings[1].key) return &SimulatedGrip::damping;
  if (key == settings[2].key) return &SimulatedGrip::mass;
  throw std::invalid_argument("no setting of a hand: " + std::string(key));
}

QString key_of(const Setting& setting) { return QStringLiteral("hand/") + setting.key; }

}  // namespace

std::span<const NamedGrip> named_grips() { return grips; }

std::span<const Setting> grip_settings() { return settings; }

double get(const SimulatedGrip& grip, std::string_view key) { return grip.*value_of(key); }

void set(SimulatedGrip& grip, std::string_view key, double value) {
  const Setting& setting = *find_setting(settings, key);
  grip.*value_of(key) = std::clamp(value, setting.minimum, setting.maximum);
}

SimulatedDeviceParameters held(SimulatedDeviceParameters device, const SimulatedGrip& grip) {
  const SimulatedDeviceParameters before;
  const double per = device.rotation.inertia / device.translation.inertia;
  device.translation.hand_stiffness = grip.stiffness;
  device.translation.hand_damping = grip.damping;
  device.rotation.hand_stiffness =
      before.rotation.hand_stiffness * grip.stiffness / usual.stiffness;
  device.rotation.hand_damping = before.rotation.hand_damping * grip.damping / usual.damping;
  device.translation.inertia += grip.mass;
  device.rotation.inertia += grip.mass * per;
  return device;
}

SimulatedGrip chosen_grip() {
  const QSettings stored;
  SimulatedGrip grip;
  for (const Setting& setting : settings)
    if (const double own = stored.value(key_of(setting), setting.fallback).toDouble();
        allowed(setting, own))
      set(grip, setting.key, own);
  return grip;
}

void keep_grip(const SimulatedGrip& grip) {
  QSettings stored;
  for (const Setting& setting : settings) stored.setValue(key_of(setting), get(grip, setting.key));
}

}  // namespace sonde::ui
