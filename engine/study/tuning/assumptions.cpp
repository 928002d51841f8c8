// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/assumptions.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include "engine/base/numbers.hpp"
#include "engine/settings/device_profile.hpp"

namespace sonde {
namespace {

AssumedEnd end_of(const TuningResults& results, GainAxis axis, const std::string& key,
                  double times) {
  AssumedEnd out{.value = results.device.at(key) * times, .gains = {}};
  if (const auto gains = recommend(results, axis, key, times)) out.gains = *gains;
  return out;
}

/// The least and the largest multiple at which a study varies a value, and where it does.
struct Varied {
  double low = 1, high = 1;
  std::string kind, hand;
};
std::map<std::string, Varied> varied_values(const TuningResults& results, GainAxis axis) {
  std::map<std::string, Varied> out;
  for (const TuningLine& line : results.lines) {
    if (line.axis != axis || line.assumed.empty()) continue;
    const Varied here{line.times, line.times, line.kind, line.hand};
    Varied& value = out.try_emplace(line.assumed, here).first->second;
    value.low = std::min(value.low, line.times);
    value.high = std::max(value.high, line.times);
  }
  return out;
}

double worse(const AssumedInterval& interval) {
  return std::min(interval.low.gains.stiffness, interval.high.gains.stiffness);
}
double better(const AssumedInterval& interval) {
  return std::max(interval.low.gains.stiffness, interval.high.gains.stiffness);
}

/// Of intervals sorted by their worse ends.
std::vector<AssumedInterval>::iterator limits_most(std::vector<AssumedInterval>& sorted) {
  if (sorted.empty()) return sorted.end();
  const double least = worse(sorted.front());
  const auto apart = std::ranges::find_if(
      sorted, [&](const AssumedInterval& each) { return worse(each) > resolved * least; });
  return std::max_element(
      sorted.begin(), apart,
      [](const AssumedInterval& a, const AssumedInterval& b) { return better(a) < better(b); });
}

}  // namespace

std::vector<AssumedInterval> assumed_intervals(const TuningResults& results, GainAxis axis) {
  std::vector<AssumedInterval> out;
  for (const auto& [key, value] : varied_values(results, axis))
    out.push_back({key, end_of(results, axis, key, value.low),
                   end_of(results, axis, key, value.high), value.kind, value.hand});
  std::ranges::stable_sort(out, {}, worse);
  const auto first = limits_most(out);
  std::rotate(out.begin(), first, first == out.end() ? first : std::next(first));
  return out;
}

bool change_gains(const std::vector<AssumedInterval>& intervals) {
  return std::ranges::any_of(
      intervals, [](const AssumedInterval& each) { return better(each) > resolved * worse(each); });
}

std::string unit_of(const AssumedInterval& interval) {
  const auto key = std::ranges::find(profile_keys(), interval.key, &ProfileKey::key);
  return key == profile_keys().end() ? std::string() : key->unit;
}

}  // namespace sonde
