// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/study/tuning/gain_recommendation.hpp"

namespace sonde {

/// The recommendation at one end of what an assumed value may be.
struct AssumedEnd {
  double value = 0;
  AxisGains gains;
};
/// A value of the profile that is not sure: an assumed one from half to twice what it says, a
/// measured one over its interval.
struct AssumedInterval {
  std::string key;
  AssumedEnd low, high;
};

/// The boundary that counts: at harder knocks or, unless it is trusted, without friction, where
/// that is lower. Infinite where nothing was unstable.
double boundary_that_counts(const TuningResults& results, const AxisGains& gains);
/// The same in one situation, hand and damping.
double boundary_that_counts(const TuningResults& results, const TuningColumn& column);

/// Of each value that the study varied, in the one situation where it did: the one at whose
/// worse end the boundary that counts is least comes first.
std::vector<AssumedInterval> assumed_intervals(const TuningResults& results, GainAxis axis);

}  // namespace sonde
