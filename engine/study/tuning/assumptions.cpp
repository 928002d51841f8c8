// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/assumptions.hpp"

#include <algorithm>
#include <utility>

#include "engine/base/numbers.hpp"

namespace sonde {
namespace {

AssumedEnd end_of(const TuningResults& results, GainAxis axis, const std::string& key,
                  double times) {
  AssumedEnd out{.value = results.device.at(key) * times, .gains = {}};
  if (const auto gains = recommend(results, axis, key, times)) out.gains = *gains;
  return out;
}

/// The least and the largest multiple of each value that a study varies.
std::map<std::string, std::pair<double, double>> varied_times(const TuningResults& results,
                                                              GainAxis axis) {
  std::map<std::string, std::pair<double, double>> out;
  for (const TuningLine& line : results.lines) {
    if (line.axis != axis || line.assumed.empty()) continue;
    auto& [low, high] = out.try_emplace(line.assumed, line.times, line.times).first->second;
    low = std::min(low, line.times);
    high = std::max(high, line.times);
  }
  return out;
}

}  // namespace

double boundary_that_counts(const TuningResults& results, const AxisGains& gains) {
  const double least = std::min(gains.boundary, gains.harder_knocks);
  return results.trusts_friction ? least : std::min(least, gains.without_friction);
}

double boundary_that_counts(const TuningResults& results, const TuningColumn& column) {
  double least = infinity;
  const auto take = [&](const std::optional<SweepLimit>& limit) {
    if (limit && limit->fault != HoldFault::none) least = std::min(least, limit->stiffness);
  };
  take(column.stable);
  take(column.harder_knocks);
  if (!results.trusts_friction) take(column.without_friction);
  return least;
}

std::vector<AssumedInterval> assumed_intervals(const TuningResults& results, GainAxis axis) {
  std::vector<AssumedInterval> out;
  for (const auto& [key, times] : varied_times(results, axis))
    out.push_back(
        {key, end_of(results, axis, key, times.first), end_of(results, axis, key, times.second)});
  std::ranges::stable_sort(out, {}, [&](const AssumedInterval& each) {
    return std::min(boundary_that_counts(results, each.low.gains),
                    boundary_that_counts(results, each.high.gains));
  });
  return out;
}

}  // namespace sonde
