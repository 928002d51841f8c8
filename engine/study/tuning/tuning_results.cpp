// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_results.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/base/error.hpp"
#include "engine/settings/settings.hpp"

namespace sonde {
namespace {

/// The values of the device's profile on which the recommendation depends.
constexpr const char* profile_values[] = {"mass",
                                          "inertia",
                                          "max_force",
                                          "max_torque",
                                          "friction",
                                          "resolution",
                                          "max_stiffness",
                                          "max_rotational_stiffness",
                                          "rotational_friction",
                                          "rotational_resolution"};

using Json = nlohmann::ordered_json;

/// JSON has no infinity: null stands for no limit.
double number(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

double number_if_any(const Json& json, const char* key) {
  return json.contains(key) ? number(json.at(key)) : std::numeric_limits<double>::infinity();
}

template <class Value>
Value named(const std::string& name, std::initializer_list<Value> values) {
  for (const Value value : values)
    if (name == name_of(value)) return value;
  throw std::invalid_argument("unknown name " + name);
}

HoldFault fault_named(const Json& json) {
  return named(json.get<std::string>(), {HoldFault::none, HoldFault::unstable, HoldFault::saturated,
                                         HoldFault::chattering, HoldFault::unfaithful});
}

SweepPoint point_of(const Json& json) {
  SweepPoint point;
  point.stiffness = json.at("stiffness").get<double>();
  HoldReport& r = point.report;
  r.stable = json.at("stable").get<bool>();
  r.chattering = json.at("chattering").get<bool>();
  r.saturated = json.at("saturated").get<bool>();
  r.growth = number(json.at("growth"));
  r.work = number(json.at("work"));
  r.chatter = number(json.at("chatter"));
  r.saturation = number(json.at("saturation"));
  r.force_error = number(json.at("force_error"));
  r.torque_error = number(json.at("torque_error"));
  r.depth = number(json.at("depth"));
  r.contact = number(json.at("contact"));
  r.force = number(json.at("force"));
  r.torque = number(json.at("torque"));
  r.jumps = json.at("jumps").get<int>();
  r.pop_throughs = json.at("pop_throughs").get<int>();
  r.failures = json.at("failures").get<int>();
  return point;
}

SweepLimit limit_of(const Json& json, const std::string& name) {
  return {json.at(name).get<double>(), fault_named(json.at(name + "_ends_by"))};
}

std::optional<SweepLimit> limit_if_any(const Json& json, const std::string& name) {
  return json.contains(name) ? std::optional(limit_of(json, name)) : std::nullopt;
}

TuningColumn column_of(const Json& json) {
  TuningColumn column;
  column.damping = json.at("damping").get<double>();
  column.theory_stable = number(json.at("theory_stable"));
  column.theory_passive = number(json.at("theory_passive"));
  column.theory_released = number_if_any(json, "theory_released");
  if (json.contains("theory_released_any_swing"))
    column.theory_released_any_swing = number(json.at("theory_released_any_swing"));
  column.theory_passive_in_translation = number_if_any(json, "theory_passive_in_translation");
  column.cycle_lever = json.value("cycle_lever", 0.0);
  column.stable = limit_of(json, "stable");
  column.good = limit_of(json, "good");
  column.without_friction = limit_if_any(json, "without_friction");
  column.harder_knocks = limit_if_any(json, "harder_knocks");
  column.without_friction_by_theory = json.value("without_friction_by_theory", false);
  if (const auto held = json.find("long_hold"); held != json.end())
    column.long_hold = {held->at("stiffness").get<double>(),
                        held->at("swings_without_friction").get<bool>(),
                        held->at("swings_at_harder_knocks").get<bool>()};
  for (const Json& run : json.at("runs")) column.runs.push_back(point_of(run));
  if (column.runs.empty()) throw std::out_of_range("a column without runs");
  return column;
}

TuningLine line_of(const Json& json) {
  TuningLine line;
  line.situation = json.at("situation").get<std::size_t>();
  line.kind = json.at("kind").get<std::string>();
  line.hand = json.at("hand").get<std::string>();
  line.axis = gain_axis_named(json.at("axis").get<std::string>());
  if (!json.at("assumed").is_null()) line.assumed = json.at("assumed").get<std::string>();
  line.times = json.at("times").get<double>();
  for (const Json& column : json.at("columns")) line.columns.push_back(column_of(column));
  if (line.columns.empty()) throw std::out_of_range("no columns");
  return line;
}

/// Lines of one axis are compared at each damping: none may lack a damping of another. Those that
/// vary an assumed value have some of the dampings of the others.
void check_dampings(const std::vector<TuningLine>& lines) {
  for (const TuningLine& line : lines)
    for (const TuningColumn& column : line.columns)
      for (const TuningLine& other : lines)
        if (other.axis == line.axis && other.assumed.empty() &&
            std::ranges::find(other.columns, column.damping, &TuningColumn::damping) ==
                other.columns.end())
          throw std::out_of_range("damping");
}

/// Copies the limit without friction of the unchanged profile to the lines that vary a friction.
void share_frictionless(std::vector<TuningLine>& lines) {
  for (TuningLine& line : lines)
    for (TuningColumn& column : line.columns) {
      if (!is_friction(line.assumed) || column.without_friction) continue;
      for (const TuningLine& other : lines) {
        if (!other.assumed.empty() || other.axis != line.axis || other.hand != line.hand ||
            other.situation != line.situation)
          continue;
        const auto& same =
            *std::ranges::find(other.columns, column.damping, &TuningColumn::damping);
        column.without_friction = same.without_friction;
        column.without_friction_by_theory = same.without_friction_by_theory;
      }
    }
}

void read_about(const Json& json, TuningResults& out) {
  out.mode = coupling_mode(json.at("mode").get<std::string>()).value();
  out.sample_time = json.at("sample_time").get<double>();
  out.max_force = json.at("max_force").get<double>();
  out.max_torque = json.at("max_torque").get<double>();
  out.trusts_friction = json.value("trusts_friction", false);
  out.always_held = json.value("always_held", false);
  out.only_kind = json.value("only_kind", std::string());
  out.largest_inertia = json.value("largest_inertia", 0.0);
  if (const auto found = json.find("damper_in_theory"); found != json.end() && !found->is_null())
    out.damper = {found->at("stiffness").get<double>(), found->at("damping").get<double>()};
  for (const auto& [key, value] : json.at("device").items())
    if (value.is_object()) out.device[key] = value.at("value").get<double>();
  for (const char* needed : profile_values)
    if (!out.device.contains(needed)) throw std::out_of_range(needed);
  out.device_id = json.at("device").at("id").get<std::string>();
  out.joint = {json.at("rotational_stiffness_per_translational").get<double>(),
               json.at("rotational_damping_per_translational").get<double>()};
  for (const Json& situation : json.at("situations"))
    out.felt.push_back({situation.at("largest_translational_stiffness").get<double>(),
                        situation.at("largest_rotational_stiffness").get<double>()});
}

}  // namespace

bool has_friction(const TuningResults& results) {
  return results.device.at("friction") > 0 || results.device.at("rotational_friction") > 0;
}

bool is_friction(const std::string& key) {
  return key == "friction" || key == "rotational_friction";
}

TuningResults results_without_lines(const std::string& about) {
  TuningResults out;
  out.about = about;
  read_about(Json::parse(about), out);
  return out;
}

TuningResults read_tuning(const std::string& folder, const StudyFolder& study) {
  TuningResults out;
  out.about = study.about;
  for (std::size_t i = 0; i < study.results.size(); ++i)
    if (!study.results[i])
      throw InputError::in(folder, "part " + study.names[i] + " is not finished");
  if (study.names.empty()) throw InputError::in(folder, "the study has no parts");
  std::string reading = "study.json";
  try {
    read_about(Json::parse(study.about), out);
    for (std::size_t i = 0; i < study.results.size(); ++i) {
      reading = "part " + study.names[i];
      if (study.names[i] == ladder_part) {
        out.ladder = rest_ladder_of(*study.results[i]);
        continue;
      }
      out.lines.push_back(line_of(Json::parse(*study.results[i])));
      if (out.lines.back().situation >= out.felt.size()) throw std::out_of_range("situation");
      check_dampings(out.lines);
    }
    share_frictionless(out.lines);
  } catch (const std::exception& error) {  // exceptions of the parser, the names and the optional
    throw InputError::in(folder, reading + " is not what a study writes: " + error.what());
  }
  return out;
}

}  // namespace sonde
