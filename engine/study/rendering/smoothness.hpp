// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// Σ |xᵢ₊₁ − xᵢ|: how far the tip of the vector goes in all. A rise to a and back is 2a, however it
/// is done; what trembles on the way adds to it.
double total_variation(std::span<const Vec3> x);

/// Power of a vector signal by frequency: of the three components together, in the square of its
/// unit. The values at frequency 0 are not there.
struct Spectrum {
  std::vector<double> frequency;  ///< Hz, evenly spaced, up to half of the rate
  std::vector<double> power;
};

/// By Welch's method: pieces of the smallest power of two that lasts half a second (all of x where
/// it is shorter), each half over the next, their means taken off, under a Hann window; the mean of
/// their periodograms. Scaled so that a sine of amplitude a at a frequency of the list adds a²/2. A
/// sine shows at its own frequency by two thirds and at each of its two neighbours by a sixth. The
/// last piece ends with the signal.
Spectrum spectrum(std::span<const Vec3> x, double rate_hz);

/// The share of the power above a frequency; no value where there is no power at all, or where no
/// frequency of the spectrum is above.
std::optional<double> share_above(const Spectrum& spectrum, double frequency);

/// The rate of evenly spaced times, Hz; no value for fewer than two, or where a step differs from
/// the mean one by more than a hundredth.
std::optional<double> sample_rate(std::span<const double> times);

}  // namespace sonde
