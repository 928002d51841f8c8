// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "engine/text/number_text.hpp"

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

template <class Target, double Target::*member>
constexpr Row<Target> number(Setting setting) {
  setting.fallback = Target{}.*member;
  return {setting, [](const Target& t) { return t.*member; },
          [](Target& t, double value) { t.*member = value; }};
}
template <double Coupling::*member>
constexpr Row<Coupling> gain(Setting setting) {
  return number<Coupling, member>(setting);
}

// clang-format off
//   key, label, unit, minimum, maximum, (fallback: from the struct), logarithmic, doc, integer, mode
constexpr std::array coupling_rows{
    gain<&Coupling::k>({"k", "Stiffness", "N/m", 1, 1e5, 0, true,
        "Object-norm stiffness: the energy is half of k times the mean squared displacement.",
        false, "object damped"}),
    gain<&Coupling::k_t>({"k_t", "Translational stiffness", "N/m", 1, 1e5, 0, true,
        "Force for each metre between the device and the separated pose.", false, "classic"}),
    gain<&Coupling::k_r>({"k_r", "Rotational stiffness", "N·m/rad", 1e-3, 100, 0, true,
        "Torque for each radian between the device and the separated pose.", false, "classic"}),
    gain<&Coupling::b_t>({"b_t", "Damping", "N·s/m", 0, 100, 0, false,
        "Classic: force for each m/s at which the separation grows, of translation. Damped: of all "
        "of the separation, its turn too. Free motion is not damped.",
        false, "classic damped"}),
    gain<&Coupling::b_r>({"b_r", "Rotational damping", "N·m·s/rad", 0, 1, 0, false,
        "Torque for each rad/s at which the separation turns; free motion is not damped.",
        false, "classic"}),
    gain<&Coupling::max_force>({"max_force", "Force limit", "N", 0.01, 1000, 0, true,
        "Largest force on the device; a larger one is scaled down and keeps its direction.",
        false, ""}),
    gain<&Coupling::max_torque>({"max_torque", "Torque limit", "N·m", 1e-4, 100, 0, true,
        "Largest torque on the device; a larger one is scaled down and keeps its direction.",
        false, ""}),
};

constexpr std::array<Choice, 3> modes{{
    {"object", "Object norm", "One stiffness k, force and torque from the same energy."},
    {"classic", "Classic", "A spring and damper for translation, another for rotation."},
    {"damped", "Damped", "Object norm, with one damper b_t for the rate of the whole separation."},
}};

constexpr std::array<Row<ServoSettings>, 9> servo_rows{{
    {{"rate_hz", "Servo rate", "Hz", 500, 10000, ServoSettings{}.rate_hz, true,
      "Ticks of the haptic loop in a second."},
     [](const ServoSettings& s) { return s.rate_hz; },
     [](ServoSettings& s, double value) { s.rate_hz = value; }},
    {{"budget_us", "Time budget", "µs", 0, 1e6, ServoSettings{}.budget.microseconds, false,
      "Wall-clock time the solver may take in a tick; 0: until it has converged. While answers do "
      "not converge, it grows to 6400 µs."},
     [](const ServoSettings& s) { return s.budget.microseconds; },
     [](ServoSettings& s, double value) { s.budget.microseconds = value; }},
    {{"budget_steps", "Work budget", "", 0, 1e6, double(ServoSettings{}.budget.steps), false,
      "Iterations the solver may take in a tick; 0: until it has converged.", true},
     [](const ServoSettings& s) { return double(s.budget.steps); },
     [](ServoSettings& s, double value) { s.budget.steps = static_cast<int>(value); }},
    {{"accuracy", "Wanted accuracy", "", 0, 0.99, ServoSettings{}.accuracy, false,
      "Error of nine in ten ticks, in parts of the largest depth; sets the time budget; 0: none."},
     [](const ServoSettings& s) { return s.accuracy; },
     [](ServoSettings& s, double value) { s.accuracy = value; }},
    {{"ramp_time", "Force ramp", "s", 0, 5, ServoSettings{}.safety.ramp_time, false,
      "Time in which the force rises from zero, after a start and after a fault."},
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
    {{"force_error", "Largest force error", "N", 0, 1e3, ServoSettings{}.safety.force_error, false,
      "Largest error of a force that has not converged; beyond it the force fades; 0: any."},
     [](const ServoSettings& s) { return s.safety.force_error; },
     [](ServoSettings& s, double value) { s.safety.force_error = value; }},
    {{"passivity_control", "Passivity control", "", 0, 1,
      double(ServoSettings{}.passivity.control), false,
      "1: damps away the energy that the loop gives to a force device; 0: only observes it.", true},
     [](const ServoSettings& s) { return double(s.passivity.control); },
     [](ServoSettings& s, double value) { s.passivity.control = value > 0; }},
}};

constexpr std::array device_rows{
    number<DeviceSettings, &DeviceSettings::scaling>({"scaling", "Workspace scaling", "", 1e-3,
        1000, 0, true, "How far the probe moves per motion of the hand; the force grows with it."}),
    number<DeviceSettings, &DeviceSettings::reach>({"reach", "Full push", "m or m/s", 1e-4, 10, 0,
        true, "How far full deflection moves the probe, or how fast."}),
    number<DeviceSettings, &DeviceSettings::turn>({"turn", "Full twist", "rad or rad/s", 0.01, 20, 0,
        true, "How far full deflection turns the probe, or how fast."}),
    number<DeviceSettings, &DeviceSettings::smoothing>({"smoothing", "Smoothing", "s", 0, 1, 0,
        false, "Time in which most of a new deflection has taken effect."}),
    Row<DeviceSettings>{
        {"clutch_button", "Clutch button", "", 0, 32, double(DeviceSettings{}.clutch_button), false,
         "Held down, it keeps the probe in place while the hand moves; 0: none.", true},
        [](const DeviceSettings& d) { return double(d.clutch_button); },
        [](DeviceSettings& d, double value) { d.clutch_button = static_cast<int>(value); }},
};

constexpr std::array axis_rows{
    number<AxisSetting, &AxisSetting::gain>({"gain", "Gain", "", 0, 10, 0, false,
        "Multiplies the axis; 0 switches it off."}),
    number<AxisSetting, &AxisSetting::dead_zone>({"dead_zone", "Dead zone", "", 0, 0.9, 0, false,
        "A deflection up to this part of the full one counts as zero."}),
    number<AxisSetting, &AxisSetting::expo>({"expo", "Expo", "", 0, 1, 0, false,
        "How much finer small deflections act: 0 all the same, 1 by the cube."}),
};

constexpr std::array<Choice, 2> controls{{
    {"position", "Position", "A deflection is a displacement: when you let go, the probe comes back."},
    {"rate", "Rate", "A deflection is a velocity: when you let go, the probe stays."},
}};
constexpr std::array<Choice, 3> frames{{
    {"view", "The picture's", "A push to the right moves the probe to the right of the picture."},
    {"scene", "The scene's, z up", "x, y and z of the device are those of the scene."},
    {"y_up", "The scene's, y up", "x, y and z of the device are x, -z and y of the scene."},
}};
constexpr std::array<Choice, 6> axes{{
    {"x", "right", "To the right."},
    {"y", "away", "Away from the user."},
    {"z", "up", "Upwards."},
    {"rx", "about x", "Tilt away from the user and back."},
    {"ry", "about y", "Tilt to the right and to the left."},
    {"rz", "about z", "Twist."},
}};

constexpr std::array<Choice, 3> models{{
    {"auto", "Automatic", "Solid where the mesh is closed as a person sees it, else surface."},
    {"solid", "Solid", "The interior counts; mass by volume."},
    {"surface", "Surface", "Only the triangles count; mass by area."},
}};
constexpr std::array<Choice, 2> repairs{{
    {"auto", "Automatic", "Cracks, turned parts and small openings are mended; nothing moves."},
    {"none", "As in the file", "A mesh with an open edge is a surface."},
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
constexpr auto device_table = settings_of(device_rows);
constexpr auto axis_table = settings_of(axis_rows);

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

}  // namespace

std::span<const Setting> coupling_settings() { return coupling_table; }
std::span<const Choice> coupling_modes() { return modes; }
std::span<const Setting> servo_settings() { return servo_table; }
std::span<const Setting> device_settings() { return device_table; }
std::span<const Setting> axis_settings() { return axis_table; }
std::span<const Choice> device_controls() { return controls; }
std::span<const Choice> device_frames() { return frames; }
std::span<const Choice> device_axes() { return axes; }

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
double get(const DeviceSettings& device, std::string_view key) {
  return row(device_rows, key).read(device);
}
void set(DeviceSettings& device, std::string_view key, double value) {
  const auto& r = row(device_rows, key);
  r.write(device, brought_in(r.setting, value));
}
double get(const AxisSetting& axis, std::string_view key) { return row(axis_rows, key).read(axis); }
void set(AxisSetting& axis, std::string_view key, double value) {
  const auto& r = row(axis_rows, key);
  r.write(axis, brought_in(r.setting, value));
}

std::optional<std::size_t> place_of(std::span<const Choice> choices, std::string_view name) {
  const auto found = std::ranges::find(choices, name, &Choice::key);
  if (found == choices.end()) return std::nullopt;
  return static_cast<std::size_t>(found - choices.begin());
}

bool is_used(const Setting& setting, Coupling::Mode mode) {
  const std::string_view all = setting.coupling_modes;  // no name is a part of another
  return all.empty() || all.find(name_of(mode)) != std::string_view::npos;
}

const char* name_of(Coupling::Mode mode) { return modes[static_cast<std::size_t>(mode)].key; }
std::optional<Coupling::Mode> coupling_mode(std::string_view name) {
  const auto i = place_of(modes, name);
  return i ? std::optional(static_cast<Coupling::Mode>(*i)) : std::nullopt;
}
const char* name_of(Model model) { return models[static_cast<std::size_t>(model)].key; }
std::optional<Model> model_named(std::string_view name) {
  const auto i = place_of(models, name);
  return i ? std::optional(static_cast<Model>(*i)) : std::nullopt;
}
const char* name_of(Repair repair) { return repairs[static_cast<std::size_t>(repair)].key; }
std::optional<Repair> repair_named(std::string_view name) {
  const auto i = place_of(repairs, name);
  return i ? std::optional(static_cast<Repair>(*i)) : std::nullopt;
}

}  // namespace sonde
