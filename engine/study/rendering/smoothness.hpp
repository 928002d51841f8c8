// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// Σ |xᵢ₊₁ − xᵢ|: the total path length of the vector's tip. A rise to a and back gives 2a, however
/// it is done; trembling adds to it.
double total_variation(std::span<const Vec3> x);

/// The power of a vector signal by frequency, summed over the three components, in the square of
/// its unit. Frequency 0 is left out.
struct Spectrum {
  std::vector<double> frequency;  ///< Hz, evenly spaced, up to half of the rate
  std::vector<double> power;
};

/// By Welch's method: the mean of the periodograms of pieces whose length is the smallest power of
/// two that lasts half a second (all of x if it is shorter), each overlapping the next by half,
/// without their means, with a Hann window. Scaled so that a sine of amplitude a at a frequency of
/// the list adds a²/2. Of a sine's power, two thirds appear at its own frequency and a sixth at
/// each of its two neighbours. The last piece ends with the signal.
Spectrum spectrum(std::span<const Vec3> x, double rate_hz);

/// The share of the power above a frequency; no value if there is no power at all, or if no
/// frequency of the spectrum is above.
std::optional<double> share_above(const Spectrum& spectrum, double frequency);

/// The rate of evenly spaced times, Hz; no value for fewer than two, or if a step differs from the
/// mean one by more than a hundredth.
std::optional<double> sample_rate(std::span<const double> times);

}  // namespace sonde
