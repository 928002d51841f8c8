// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_words.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "engine/settings/device_profile.hpp"
#include "engine/study/tuning/assumptions.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

/// Three digits, or all before the point.
std::string short_text(double value) {
  return value >= 1000 && value < 1e9 ? number_text(std::round(value)) : number_text(value, 3);
}

/// In words where the name of a reason is not one.
std::string words_of(const std::string& reason) {
  constexpr std::pair<std::string_view, const char*> words[] = {
      {"friction", "stability without friction"},
      {"knocks", "stability at harder knocks"},
      {"driver", "the driver's largest stiffness"},
      {"resolution", "the encoder's steps"},
      {"range", "the range studied"}};
  for (const auto& [name, meaning] : words)
    if (reason == name) return meaning;
  return reason;
}

std::string where(const GainLimit& limit) {
  if (limit.kind.empty()) return {};
  return " (" + limit.kind + " contact" + (limit.hand.empty() ? "" : ", " + limit.hand + " hand") +
         ")";
}
std::string why(const GainLimit& limit) {
  return "limited by " + words_of(limit.reason) + where(limit);
}

const char* stiffness_unit(GainAxis axis) {
  return axis == GainAxis::rotation ? " N·m/rad" : " N/m";
}
std::string damping_text(const AxisGains& gains) {
  const bool turns = gains.axis == GainAxis::rotation;
  return (turns ? "b_r " : "b_t ") + short_text(gains.damping) + (turns ? " N·m·s/rad" : " N·s/m");
}
std::string stiffness_text(const AxisGains& gains) {
  return short_text(gains.stiffness) + stiffness_unit(gains.axis);
}

std::string gains_text(const AxisGains& gains, const JointGains& joint) {
  if (gains.axis == GainAxis::object) return "k " + stiffness_text(gains);
  std::string out = (gains.axis == GainAxis::rotation ? "k_r " : "k_t ") + stiffness_text(gains);
  if (gains.axis == GainAxis::together)
    out += ", k_r " + short_text(gains.stiffness * joint.stiffness) + " N·m/rad";
  if (gains.damping == 0) return out + ", no damping";
  out += ", " + damping_text(gains);
  if (gains.axis == GainAxis::together)
    out += ", b_r " + short_text(gains.damping * joint.damping) + " N·m·s/rad";
  return out;
}

/// Empty where the gains cannot be damped, or are.
std::string why_no_damping(const TuningResults& results, const AxisGains& best) {
  const auto each = recommend_at_each_damping(results, best.axis);
  if (best.damping > 0 || best.stiffness <= 0 || each.size() < 2) return {};
  const AxisGains& next = each[1];
  return "no virtual damping is best: at " + damping_text(next) + " the stiffness may be " +
         stiffness_text(next) + ", " + why(next.limit);
}

std::string beyond_theory(const AxisGains& gains) {
  if (!(gains.stiffness > gains.theory)) return {};
  return "that is above the limit in theory, which has no friction: " + short_text(gains.theory) +
         stiffness_unit(gains.axis);
}

std::string contacts_text(const std::vector<GainLimit>& places) {
  std::string out;
  for (const GainLimit& each : places)
    out += (out.empty() ? "the " : ", the ") + each.kind + " contact (" + each.hand + " hand)";
  return out;
}

/// Of what was held for seconds.
std::vector<std::string> lasting_swings(const TuningResults& results, const AxisGains& gains) {
  if (gains.stiffness <= 0) return {};
  if (gains.held_at == 0)
    return {
        "whether the probe swings on for seconds, without friction or after a hard knock, was "
        "not looked at"};
  const std::string at = "at " + short_text(gains.held_at) + stiffness_unit(gains.axis) +
                         (held_elsewhere(gains) ? ", far from these gains," : ",");
  const std::string knock =
      "after a knock of " + short_text(std::ranges::max(harder_knocks)) + " times the strength";
  const bool trusts = trusts_friction(results);
  std::vector<std::string> out;
  if (!trusts && !gains.swings_without_friction.empty())
    out.push_back((has_friction(results) ? "these gains may rely on friction: without it, "
                                         : "the device has no friction: ") +
                  at + " the probe swings on in " + contacts_text(gains.swings_without_friction));
  if (!gains.swings_at_harder_knocks.empty())
    out.push_back(knock + ", " + at + " the probe swings on in " +
                  contacts_text(gains.swings_at_harder_knocks));
  if (out.empty())
    out.push_back("held for seconds " + at + (trusts ? " " : " once without friction and once ") +
                  knock + ", the probe comes to rest");
  return out;
}

std::string limiting_assumption_text(const TuningResults& results, GainAxis axis) {
  const auto intervals = assumed_intervals(results, axis);
  if (intervals.empty()) return {};
  const AssumedInterval& worst = intervals.front();
  const auto key = std::ranges::find(profile_keys(), worst.key, &ProfileKey::key);
  const std::string unit = key == profile_keys().end() ? "" : std::string(" ") + key->unit;
  const auto end = [&](const AssumedEnd& at) {
    return stiffness_text(at.gains) + " at " + short_text(at.value) + unit;
  };
  std::string name = worst.key;
  std::ranges::replace(name, '_', ' ');
  return "of the device's values that are not sure, the " + name +
         " limits most: " + end(worst.low) + ", " + end(worst.high);
}

/// Empty where only one hand was studied.
std::string hands_text(const TuningResults& results, const AxisGains& gains) {
  const auto by_hand = recommend_by_hand(results, gains.axis, gains.damping);
  if (by_hand.size() < 2) return {};
  std::string out = "how the hand holds is assumed too: alone,";
  const char* separator = " ";
  for (const auto& [hand, alone] : by_hand) {
    out += separator + ("the " + hand + " one allows " + stiffness_text(alone));
    separator = ", ";
  }
  return out;
}

}  // namespace

std::optional<TuningResults> tuning_so_far(const std::string& folder, const StudyFolder& study,
                                           GainAxis axis) {
  const StudyFolder finished = study.finished();
  if (finished.names.empty()) return std::nullopt;
  TuningResults results = read_tuning(folder, finished);
  std::erase_if(results.lines,
                [&](const TuningLine& line) { return line.axis != axis || !line.assumed.empty(); });
  return results.lines.empty() ? std::nullopt : std::optional(std::move(results));
}

std::string gains_in_words(const TuningResults& results) {
  std::string out;
  for (const GainAxis axis : recommended_axes(results)) {
    const auto gains = recommend(results, axis);
    if (!gains) continue;
    if (!out.empty()) out += "; ";
    out += gains->stiffness > 0 ? gains_text(*gains, results.joint) : "no stiffness is good";
    out += ", " + why(gains->limit);
  }
  return out;
}

std::vector<std::string> recommendation_in_words(const TuningResults& results) {
  std::vector<std::string> out{gains_in_words(results)};
  const auto add = [&](const std::string& sentence) {
    if (!sentence.empty()) out.push_back(sentence);
  };
  for (const GainAxis axis : recommended_axes(results)) {
    const auto gains = recommend(results, axis);
    if (!gains) continue;
    for (const std::string& sentence : lasting_swings(results, *gains)) add(sentence);
    add(beyond_theory(*gains));
    add(why_no_damping(results, *gains));
    add(limiting_assumption_text(results, axis));
    add(hands_text(results, *gains));
  }
  return out;
}

}  // namespace sonde
