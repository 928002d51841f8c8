// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sonde::bench {
namespace {

constexpr std::size_t enough_for_p999 = 1000;

std::vector<double> first(std::vector<double> values, std::size_t count) {
  values.resize(std::min(count, values.size()));
  return values;
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("median of no values");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) throw std::invalid_argument("percentile of no values");
  // 0.99 · 100 is 99 and not the 99.00000000000001 that doubles may make of it.
  const double rank = std::ceil(share * static_cast<double>(values.size()) - 1e-9);
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = static_cast<std::ptrdiff_t>(std::clamp(rank - 1, 0.0, last));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

std::vector<double> times_of_poses(const Calls& calls) {
  std::vector<double> out;
  for (const auto& repetitions : calls) out.push_back(median(repetitions));
  return out;
}

Statistics summarize(const Calls& calls) {
  std::vector<double> all;
  for (const auto& repetitions : calls)
    all.insert(all.end(), repetitions.begin(), repetitions.end());
  const std::vector<double> poses = times_of_poses(calls);
  Statistics out{poses.size(), all.size(), median(poses), percentile(poses, 0.99), {}};
  if (all.size() >= enough_for_p999) out.tail = percentile(all, 0.999) / percentile(all, 0.99);
  return out;
}

double ratio_of_medians(const Calls& theirs, const Calls& ours) {
  const std::size_t common = std::min(theirs.size(), ours.size());
  return median(first(times_of_poses(theirs), common)) /
         median(first(times_of_poses(ours), common));
}

}  // namespace sonde::bench
