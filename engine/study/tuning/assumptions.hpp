// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde {

/// The recommendation at one end of the range of an uncertain value.
struct AssumedEnd {
  double value = 0;
  AxisGains gains;
};
/// An uncertain value of the profile: an assumed one is varied from half to twice its value, a
/// measured one over its interval.
struct AssumedInterval {
  std::string key;
  AssumedEnd low, high;
  std::string kind, hand;  ///< the one situation in which it was varied
};

/// Recommendations closer than this ratio are the same: a search at other values, or in another
/// hand, resolves no more.
constexpr double resolved = 1.05;

/// For each value that the study varied, in the one situation where it did; first the one that
/// limits the recommended stiffness most. At its worse end least is recommended; of those that the
/// search cannot tell apart there, it is the one at whose better end most is. The others follow by
/// their worse ends.
std::vector<AssumedInterval> assumed_intervals(const TuningResults& results, GainAxis axis);

/// Whether the search can tell the recommendations at the ends of any of them apart.
bool change_gains(const std::vector<AssumedInterval>& intervals);

/// The unit of a value of the profile; empty if it has none.
std::string unit_of(const AssumedInterval& interval);

}  // namespace sonde
