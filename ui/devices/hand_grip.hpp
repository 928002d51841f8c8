// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/settings/settings.hpp"

namespace sonde::ui {

/// How the simulated hand holds a simulated device: a spring and a damper to where the mouse wants
/// the probe, and a mass that moves with the handle.
struct SimulatedGrip {
  double stiffness = 300;  ///< N/m
  double damping = 5;      ///< N·s/m
  double mass = 0;         ///< kg
  bool operator==(const SimulatedGrip&) const = default;
};

/// A grip with a name.
struct NamedGrip {
  const char* name;  ///< "light", "usual", "firm"
  SimulatedGrip grip;
  const char* doc;
};
/// The light and the firm hand of a study (hand_grips), and between them that of a simulated device
/// unless another is chosen.
std::span<const NamedGrip> named_grips();

/// hand_stiffness, hand_damping, hand_mass: settings of the window, which no scene has.
std::span<const Setting> grip_settings();
/// The value of one of these; std::invalid_argument for another key.
double get(const SimulatedGrip& grip, std::string_view key);
void set(SimulatedGrip& grip, std::string_view key, double value);

/// The device in this grip. Rotations are held in proportion: so many times the usual stiffness and
/// damping as translations, and inertia as much more as mass.
SimulatedDeviceParameters held(SimulatedDeviceParameters device, const SimulatedGrip& grip);

/// The grip that was chosen last, kept between runs.
SimulatedGrip chosen_grip();
void keep_grip(const SimulatedGrip& grip);

}  // namespace sonde::ui
