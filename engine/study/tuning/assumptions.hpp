// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
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
};

/// The least stability limit: at harder knocks or, unless friction is trusted, without friction, if
/// that is lower. Infinite if nothing was unstable.
double boundary_that_counts(const TuningResults& results, const AxisGains& gains);
/// The same in one situation, with one hand and damping.
double boundary_that_counts(const TuningResults& results, const TuningColumn& column);

/// For each value that the study varied, in the one situation where it did; first the value at
/// whose worse end the stability limit is least.
std::vector<AssumedInterval> assumed_intervals(const TuningResults& results, GainAxis axis);

}  // namespace sonde
