// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/base/elementary.hpp"
#include "engine/settings/settings.hpp"
#include "engine/study/tuning/assumptions.hpp"
#include "engine/study/tuning/device_curves.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"
#include "engine/study/tuning/tuning_map.hpp"
#include "engine/study/tuning/tuning_words.hpp"
#include "engine/text/json_numbers.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const GainLimit& limit) {
  Json out{{"reason", limit.reason}, {"stiffness", number_or_null(limit.stiffness)}};
  if (!limit.kind.empty()) out["situation"] = limit.kind;
  if (!limit.hand.empty()) out["hand"] = limit.hand;
  return out;
}

Json json_of_swing(const Swing& swing) {
  return {{"situation", swing.kind},
          {"hand", swing.hand},
          {"friction", swing.friction},
          {"knock", swing.knock},
          {"amplitude", number_or_null(swing.amplitude)},
          {"frequency", number_or_null(swing.frequency)}};
}

/// Null if nothing was held for seconds.
Json json_of_swings(const AxisGains& gains, const std::vector<GainLimit>& places) {
  if (gains.held_at == 0 && !gains.tried) return nullptr;
  Json out = Json::array();
  for (const GainLimit& each : places)
    out.push_back({{"situation", each.kind},
                   {"hand", each.hand},
                   {"theory_stable", number_or_null(each.stiffness)}});
  return out;
}

/// Null if theory does not say, or says no more than that it does not buzz.
Json stable_if_let_go(const AxisGains& gains) {
  const LetGo then = if_let_go(gains);
  if (then == LetGo::unknown || then == LetGo::no_buzz) return nullptr;
  return then == LetGo::stable;
}

Json json_of(const AxisGains& gains) {
  Json limits = Json::array();
  for (const GainLimit& limit : gains.limits) limits.push_back(json_of(limit));
  return {{"stiffness", gains.stiffness},
          {"damping", gains.damping},
          {"limited_by", json_of(gains.limit)},
          {"boundary", number_or_null(gains.boundary)},
          {"margin", number_or_null(gains.margin())},
          {"boundary_without_friction", number_or_null(gains.without_friction)},
          {"boundary_without_friction_by_theory", gains.without_friction_by_theory},
          {"boundary_at_harder_knocks", number_or_null(gains.harder_knocks)},
          {"theory_stable", number_or_null(gains.theory)},
          {"theory_passive", number_or_null(gains.passive)},
          {"theory_passive_in_translation", number_or_null(gains.passive_in_translation)},
          {"theory_released", number_or_null(gains.released)},
          {"theory_released_any_swing",
           gains.released_any_swing ? number_or_null(*gains.released_any_swing) : Json(nullptr)},
          {"stable_if_let_go", stable_if_let_go(gains)},
          {"cycle_lever", gains.cycle_lever},
          {"longest_to_rest",
           gains.held_at > 0 && gains.tried ? Json(gains.longest_to_rest) : Json(nullptr)},
          {"swings_on", gains.swings ? json_of_swing(*gains.swings) : Json(nullptr)},
          {"held_for_seconds_at", gains.held_at > 0 ? Json(gains.held_at) : Json(nullptr)},
          {"swings_without_friction_in", json_of_swings(gains, gains.swings_without_friction)},
          {"swings_at_harder_knocks_in", json_of_swings(gains, gains.swings_at_harder_knocks)},
          {"limits", limits}};
}

/// The run nearest to the recommended gains in each situation and hand.
Json fidelity(const TuningResults& results, const AxisGains& gains) {
  Json out = Json::array();
  for (const TuningLine& line : results.lines) {
    if (line.axis != gains.axis || !line.assumed.empty() || gains.stiffness <= 0) continue;
    const auto column = std::ranges::find(line.columns, gains.damping, &TuningColumn::damping);
    if (column == line.columns.end() || column->runs.empty()) continue;
    const SweepPoint& run =
        *std::ranges::min_element(column->runs, {}, [&](const SweepPoint& each) {
          return std::abs(elementary::log(each.stiffness / gains.stiffness));
        });
    const HoldReport& r = run.report;
    out.push_back({{"situation", line.kind},
                   {"hand", line.hand},
                   {"at_stiffness", run.stiffness},
                   {"force_error", number_or_null(r.force_error)},
                   {"torque_error", number_or_null(r.torque_error)},
                   {"chatter", r.chatter},
                   {"depth", r.depth},
                   {"force", r.force},
                   {"torque", r.torque},
                   {"jumps", r.jumps},
                   {"pop_throughs", r.pop_throughs}});
  }
  return out;
}

/// The recommendation at half and twice each assumed value, in the one situation that is varied.
Json assumed_values(const TuningResults& results, GainAxis axis) {
  std::vector<std::pair<std::string, double>> seen;
  Json out = Json::array();
  for (const TuningLine& line : results.lines) {
    const std::pair<std::string, double> key{line.assumed, line.times};
    if (line.axis != axis || line.assumed.empty() || std::ranges::find(seen, key) != seen.end())
      continue;
    seen.push_back(key);
    const auto gains = recommend(results, axis, line.assumed, line.times);
    out.push_back({{"assumed", line.assumed},
                   {"times", line.times},
                   {"value", results.device.at(line.assumed) * line.times},
                   {"stiffness", gains->stiffness},
                   {"damping", gains->damping},
                   {"boundary", number_or_null(gains->boundary)},
                   {"boundary_without_friction", number_or_null(gains->without_friction)},
                   {"limited_by", gains->limit.reason}});
  }
  return out;
}

Json json_of(const AssumedEnd& end) {
  return {{"value", end.value},
          {"stiffness", end.gains.stiffness},
          {"boundary", number_or_null(end.gains.boundary)},
          {"boundary_without_friction", number_or_null(end.gains.without_friction)},
          {"limited_by", end.gains.limit.reason}};
}

/// The assumed value that limits the recommendation most, at both ends of its interval; also if
/// none changes it.
Json limiting_assumption(const TuningResults& results, GainAxis axis) {
  const std::vector<AssumedInterval> intervals = assumed_intervals(results, axis);
  if (intervals.empty()) return nullptr;
  const AssumedInterval& worst = intervals.front();
  return {{"assumed", worst.key},
          {"low", json_of(worst.low)},
          {"high", json_of(worst.high)},
          {"changes_gains", change_gains(intervals)}};
}

/// Null if nothing is good.
void add_damping_ratios(Json& json, const TuningResults& results, const AxisGains& gains) {
  const DampingRatios ratios = damping_ratios(results, gains);
  const auto ratio = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
  };
  const bool turns = gains.axis == GainAxis::rotation;
  json["damping_ratio"] = ratio(turns ? ratios.rotation : ratios.translation);
  if (is_joint(gains.axis)) json["rotational_damping_ratio"] = ratio(ratios.rotation);
}

/// The result for each damping: the reason for the recommended one.
Json dampings(const TuningResults& results, GainAxis axis) {
  Json out = Json::array();
  for (const AxisGains& gains : recommend_at_each_damping(results, axis)) {
    Json each{{"damping", gains.damping}, {"stiffness", gains.stiffness}};
    add_damping_ratios(each, results, gains);
    each["boundary"] = number_or_null(gains.boundary);
    each["limited_by"] = json_of(gains.limit);
    out.push_back(each);
  }
  return out;
}

/// The grip of the hand is an assumption too: the result for each hand alone.
Json hands(const TuningResults& results, const AxisGains& gains) {
  Json out = Json::array();
  for (const auto& [hand, alone] : recommend_by_hand(results, gains.axis, gains.damping))
    out.push_back({{"hand", hand},
                   {"boundary", number_or_null(alone.boundary)},
                   {"boundary_without_friction", number_or_null(alone.without_friction)},
                   {"stiffness", alone.stiffness},
                   {"limited_by", alone.limit.reason}});
  return out;
}

Json json_of(const TuningResults& results, GainAxis axis) {
  const auto gains = recommend(results, axis);
  const auto recommended = recommended_axes(results);
  Json out{{"axis", name_of(axis)},
           {"unit", axis == GainAxis::rotation ? "N·m/rad" : "N/m"},
           {"damping_unit", damps_turns(axis) ? "N·m·s/rad" : "N·s/m"},
           {"recommended", std::ranges::find(recommended, axis) != recommended.end()}};
  if (!gains) return out;
  out.update(json_of(*gains));
  add_damping_ratios(out, results, *gains);
  if (is_joint(axis)) {
    const Coupling c = coupling_of(*gains, results.joint);
    out["rotational_stiffness"] = c.k_r;
    out["translational_damping"] = c.b_t;
    out["rotational_damping"] = c.b_r;
  }
  out["fidelity"] = fidelity(results, *gains);
  out["dampings"] = dampings(results, axis);
  out["hands"] = hands(results, *gains);
  if (const auto beside = recommend_as_varied(results, axis)) {
    for (const TuningLine& line : results.lines)
      if (line.axis == axis && !line.assumed.empty()) out["assumed_in"] = line.kind;
    out["as_assumed"] = {{"stiffness", beside->stiffness},
                         {"damping", beside->damping},
                         {"boundary", number_or_null(beside->boundary)},
                         {"limited_by", beside->limit.reason}};
    out["assumed"] = assumed_values(results, axis);
    out["limiting_assumption"] = limiting_assumption(results, axis);
  }
  return out;
}

/// Measured values whose interval is too narrow for the search to distinguish its ends.
Json closely_measured(const TuningResults& results, const Json& about) {
  Json out = Json::array();
  if (!about.contains("device")) return out;
  for (const auto& [key, value] : about.at("device").items())
    if (value.is_object() && value.contains("low") &&
        std::ranges::find(results.lines, key, &TuningLine::assumed) == results.lines.end())
      out.push_back(key);
  return out;
}

std::string recommendation(const TuningResults& results) {
  Json axes = Json::array();
  for (const GainAxis axis : axes_of(results)) axes.push_back(json_of(results, axis));
  const Json about = Json::parse(results.about);
  const Json out{{"device", results.device_id},
                 {"mode", name_of(results.mode)},
                 {"stability_margin", stability_margin},
                 {"trusts_friction", results.trusts_friction},
                 {"always_held", results.always_held},
                 {"harder_knocks", harder_knocks},
                 {"in_words", recommendation_in_words(results)},
                 {"axes", axes},
                 {"measured_closely", closely_measured(results, about)},
                 {"situations", about.at("situations")},
                 {"skipped", about.value("skipped", Json::array())},
                 {"study", about}};
  return out.dump(2) + "\n";
}

/// The keys that the mode uses, as a scene's coupling.
std::string coupling_text(const TuningResults& results) {
  const Coupling coupling = recommended_coupling(results);
  Json out{{"mode", name_of(coupling.mode)}};
  for (const Setting& setting : coupling_settings()) {
    if (is_used(setting, coupling.mode)) out[setting.key] = get(coupling, setting.key);
  }
  return out.dump(2) + "\n";
}

}  // namespace

std::vector<StudyFile> tuning_files(const std::string& folder, const StudyFolder& study) {
  const TuningResults results = read_tuning(folder, study);
  std::vector<StudyFile> files{{"map.csv", map_csv(results)},
                               {"map.svg", map_svg(results)},
                               {"recommendation.json", recommendation(results)}};
  for (StudyFile& file : device_curve_files(results)) files.push_back(std::move(file));
  if (has_recommendation(results)) files.push_back({"coupling.json", coupling_text(results)});
  return files;
}

}  // namespace sonde
