// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "engine/scene/number_text.hpp"

namespace sonde {
namespace {

/// A setting joined to the place its value lives in. A servo value may be a whole number inside a
/// nested struct, which no member pointer reaches: hence two small functions.
template <class Target>
struct Row {
  Setting setting;
  double (*read)(const Target&);
  void (*write)(Target&, double);
};

template <double Coupling::*member>
constexpr Row<Coupling> gain(Setting setting) {
  setting.fallback = Coupling{}.*member;
  return {setting, [](const Coupling& c) { return c.*member; },
          [](Coupling& c, double value) { c.*member = value; }};
}

// clang-format off
//   key, label, unit, minimum, maximum, (fallback: from the struct), logarithmic, doc, integer, mode
constexpr std::array coupling_rows{
    gain<&Coupling::k>({"k", "Stiffness", "N/m", 1, 1e5, 0, true,
        "Object-norm stiffness: the energy is half of k times the mean squared displacement.",
        false, "object"}),
    gain<&Coupling::k_t>({"k_t", "Translational stiffness", "N/m", 1, 1e5, 0, true,
        "Force for each metre between the device and the separated pose.", false, "classic"}),
    gain<&Coupling::k_r>({"k_r", "Rotational stiffness", "N·m/rad", 1e-3, 100, 0, true,
        "Torque for each radian between the device and the separated pose.", false, "classic"}),
    gain<&Coupling::b_t>({"b_t", "Translational damping", "N·s/m", 0, 100, 0, false,
        "Force for each m/s at which the separation grows; free motion is not damped.",
        false, "classic"}),
    gain<&Coupling::b_r>({"b_r", "Rotational damping", "N·m·s/rad", 0, 1, 0, false,
        "Torque for each rad/s at which the separation turns; free motion is not damped.",
        false, "classic"}),
    gain<&Coupling::max_force>({"max_force", "Force limit", "N", 0.01, 1000, 0, true,
        "Largest force the device is asked for; beyond it the force keeps its direction only.",
        false, ""}),
    gain<&Coupling::max_torque>({"max_torque", "Torque limit", "N·m", 1e-4, 100, 0, true,
        "Largest torque the device is asked for; beyond it the torque keeps its direction only.",
        false, ""}),
};

constexpr std::array<Choice, 2> modes{{
    {"object", "Object norm", "One stiffness k, force and torque from the same energy."},
    {"classic", "Classic", "A spring and damper for translation, another for rotation."},
}};

constexpr std::array<Row<ServoSettings>, 7> servo_rows{{
    {{"rate_hz", "Servo rate", "Hz", 500, 10000, ServoSettings{}.rate_hz, true,
      "Ticks of the haptic loop in a second."},
     [](const ServoSettings& s) { return s.rate_hz; },
     [](ServoSettings& s, double value) { s.rate_hz = value; }},
    {{"budget_us", "Time budget", "µs", 0, 1e6, ServoSettings{}.budget.microseconds, false,
      "Wall-clock time the solver may take in a tick; 0: until it has converged."},
     [](const ServoSettings& s) { return s.budget.microseconds; },
     [](ServoSettings& s, double value) { s.budget.microseconds = value; }},
    {{"budget_steps", "Work budget", "", 0, 1e6, double(ServoSettings{}.budget.steps), false,
      "Iterations the solver may take in a tick; 0: until it has converged.", true},
     [](const ServoSettings& s) { return double(s.budget.steps); },
     [](ServoSettings& s, double value) { s.budget.steps = static_cast<int>(value); }},
    {{"ramp_time", "Force ramp", "s", 0, 5, ServoSettings{}.safety.ramp_time, false,
      "Time in which the force comes in from zero, after a start and after a fault."},
     [](const ServoSettings& s) { return s.safety.ramp_time; },
     [](ServoSettings& s, double value) { s.safety.ramp_time = value; }},
    {{"force_slew", "Force slew limit", "N/s", 0, 1e6, ServoSettings{}.safety.force_slew, false,
      "Largest change of the force in a second; 0: no limit."},
     [](const ServoSettings& s) { return s.safety.force_slew; },
     [](ServoSettings& s, double value) { s.safety.force_slew = value; }},
    {{"torque_slew", "Torque slew limit", "N·m/s", 0, 1e5, ServoSettings{}.safety.torque_slew,
      false, "Largest change of the torque in a second; 0: no limit."},
     [](const ServoSettings& s) { return s.safety.torque_slew; },
     [](ServoSettings& s, double value) { s.safety.torque_slew = value; }},
    {{"passivity_control", "Passivity control", "", 0, 1,
      double(ServoSettings{}.passivity.control), false,
      "1: damps away the energy that the loop has put into the hand; 0: only observes it.", true},
     [](const ServoSettings& s) { return double(s.passivity.control); },
     [](ServoSettings& s, double value) { s.passivity.control = value > 0; }},
}};

constexpr std::array<Choice, 3> models{{
    {"auto", "Automatic", "Solid where the mesh is closed, else surface."},
    {"solid", "Solid", "The interior counts; mass by volume."},
    {"surface", "Surface", "Only the triangles count; mass by area."},
}};
// clang-format on

template <class Target, std::size_t n>
constexpr std::array<Setting, n> settings_of(const std::array<Row<Target>, n>& rows) {
  std::array<Setting, n> settings{};
  std::ranges::transform(rows, settings.begin(), &Row<Target>::setting);
  return settings;
}
constexpr auto coupling_table = settings_of(coupling_rows);
constexpr auto servo_table = settings_of(servo_rows);

const auto& row(const auto& rows, std::string_view key) {
  const auto found = std::ranges::find(rows, key, [](const auto& r) { return r.setting.key; });
  if (found == rows.end()) throw std::invalid_argument("no setting " + std::string(key));
  return *found;
}

double brought_in(const Setting& setting, double value) {
  if (!std::isfinite(value)) throw std::invalid_argument(std::string(setting.key) + " not finite");
  const double inside = std::clamp(value, setting.minimum, setting.maximum);
  return setting.integer ? std::round(inside) : inside;
}

/// The place of a name in a table of choices.
std::optional<std::size_t> place(std::span<const Choice> choices, std::string_view name) {
  const auto found = std::ranges::find(choices, name, &Choice::key);
  if (found == choices.end()) return std::nullopt;
  return static_cast<std::size_t>(found - choices.begin());
}

}  // namespace

std::span<const Setting> coupling_settings() { return coupling_table; }
std::span<const Choice> coupling_modes() { return modes; }
std::span<const Setting> servo_settings() { return servo_table; }

const Setting* find_setting(std::span<const Setting> settings, std::string_view key) {
  const auto found = std::ranges::find(settings, key, &Setting::key);
  return found == settings.end() ? nullptr : &*found;
}

bool allowed(const Setting& setting, double value) {
  return std::isfinite(value) && value >= setting.minimum && value <= setting.maximum &&
         (!setting.integer || value == std::round(value));
}

std::string range_text(const Setting& setting) {
  std::string text = setting.integer ? "a whole number between " : "between ";
  text += number_text(setting.minimum, 9) + " and " + number_text(setting.maximum, 9);
  if (*setting.unit != 0) text += std::string(" ") + setting.unit;
  return text;
}

double get(const Coupling& coupling, std::string_view key) {
  return row(coupling_rows, key).read(coupling);
}
void set(Coupling& coupling, std::string_view key, double value) {
  const auto& r = row(coupling_rows, key);
  r.write(coupling, brought_in(r.setting, value));
}
double get(const ServoSettings& servo, std::string_view key) {
  return row(servo_rows, key).read(servo);
}
void set(ServoSettings& servo, std::string_view key, double value) {
  const auto& r = row(servo_rows, key);
  r.write(servo, brought_in(r.setting, value));
}

const char* name_of(Coupling::Mode mode) { return modes[static_cast<std::size_t>(mode)].key; }
std::optional<Coupling::Mode> coupling_mode(std::string_view name) {
  const auto i = place(modes, name);
  return i ? std::optional(static_cast<Coupling::Mode>(*i)) : std::nullopt;
}
const char* name_of(Model model) { return models[static_cast<std::size_t>(model)].key; }
std::optional<Model> model_named(std::string_view name) {
  const auto i = place(models, name);
  return i ? std::optional(static_cast<Model>(*i)) : std::nullopt;
}

}  // namespace sonde
