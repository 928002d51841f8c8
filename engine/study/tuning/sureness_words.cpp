// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/sureness_words.hpp"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "engine/base/numbers.hpp"
#include "engine/study/tuning/assumptions.hpp"
#include "engine/study/tuning/gain_words.hpp"

namespace sonde {
namespace {

std::string with_spaces(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

/// What a value does to the gains, as shares of them.
struct ValueEffect {
  std::string name;
  double least = 1, most = 1;
  double size() const { return std::max(most, least > 0 ? 1 / least : infinity); }
};

/// The largest first.
std::vector<ValueEffect> effects_of(const TuningResults& results, GainAxis axis) {
  std::vector<ValueEffect> out;
  const auto as_is = recommend_as_varied(results, axis);
  if (!as_is || !(as_is->stiffness > 0)) return out;
  for (const AssumedInterval& each : assumed_intervals(results, axis)) {
    const double low = each.low.gains.stiffness / as_is->stiffness;
    const double high = each.high.gains.stiffness / as_is->stiffness;
    out.push_back({with_spaces(each.key), std::min({1.0, low, high}), std::max({1.0, low, high})});
  }
  std::ranges::stable_sort(out, std::greater{}, &ValueEffect::size);
  return out;
}

/// Empty if nothing was varied, or no value matters.
std::string effects_text(const TuningResults& results, GainAxis axis) {
  std::string strong, weak;
  for (const ValueEffect& effect : effects_of(results, axis)) {
    if (effect.size() < resolved)
      weak += (weak.empty() ? "" : ", ") + effect.name;
    else
      strong += (strong.empty() ? "" : ", ") + effect.name + " " + short_number(effect.least) +
                " to " + short_number(effect.most) + " times";
  }
  if (strong.empty()) return {};
  return "it rests on values that are not sure; the ends of each (half and twice, if it is "
         "assumed) make of the stiffness: " +
         strong + (weak.empty() ? "" : "; hardly on the " + weak);
}

/// The profile's assumed values, if a study has varied none of them.
std::string not_varied(const TuningResults& results) {
  const auto about = nlohmann::json::parse(results.about, nullptr, false);
  const auto device = about.is_object() ? about.find("device") : about.end();
  if (device == about.end() || !device->is_object()) return {};
  std::string names;
  for (const auto& [key, value] : device->items())
    if (value.is_object() && value.contains("assumed"))
      names += (names.empty() ? "" : ", ") + with_spaces(key);
  return names.empty() ? names : "it rests on assumed " + names + ", which this study did not vary";
}

/// Values are varied in one situation: the recommendation may be lower by another, or by the trial
/// of what comes to rest.
std::string varied_in(const TuningResults& results, GainAxis axis, const AssumedInterval& value) {
  const auto as_is = recommend_as_varied(results, axis);
  return "by the limits of the " + value.kind + " contact (" + value.hand + " hand) alone, " +
         (as_is ? stiffness_in_words(axis, as_is->stiffness) + " as it is, " : "");
}

std::string limiting_assumption_text(const TuningResults& results, GainAxis axis) {
  const auto intervals = assumed_intervals(results, axis);
  if (intervals.empty()) return {};
  const AssumedInterval& most = intervals.front();
  if (!change_gains(intervals))
    return "none of the device's values that are not sure changes the gains: " +
           stiffness_in_words(axis, most.low.gains.stiffness) +
           " at both ends of each, by the limits of the " + most.kind + " contact (" + most.hand +
           " hand) alone";
  const std::string unit = unit_of(most).empty() ? "" : " " + unit_of(most);
  const auto end = [&](const AssumedEnd& at) {
    return stiffness_in_words(axis, at.gains.stiffness) + " at " + short_number(at.value) + unit;
  };
  return "of the device's values that are not sure, the " + with_spaces(most.key) +
         " limits most: " + varied_in(results, axis, most) + end(most.low) + ", " + end(most.high);
}

}  // namespace

std::vector<std::string> sureness_in_words(const TuningResults& results, GainAxis axis) {
  std::vector<std::string> out;
  for (const std::string& words :
       {effects_text(results, axis), limiting_assumption_text(results, axis)})
    if (!words.empty()) out.push_back(words);
  if (assumed_intervals(results, axis).empty())
    if (const std::string words = not_varied(results); !words.empty()) out.push_back(words);
  return out;
}

}  // namespace sonde
