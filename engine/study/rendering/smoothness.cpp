// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/rendering/smoothness.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/base/elementary.hpp"
#include "engine/study/parts/fourier.hpp"

namespace sonde {
namespace {

constexpr double piece_seconds = 0.5;

std::size_t piece_length(std::size_t samples, double rate_hz) {
  std::size_t length = 4;
  while (static_cast<double>(length) < piece_seconds * rate_hz) length *= 2;
  return std::min(length, samples);
}

/// The start indices of the pieces: half a length apart, the last one so that it ends with the
/// signal.
std::vector<std::size_t> beginnings(std::size_t samples, std::size_t length) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i + length < samples; i += length / 2) out.push_back(i);
  out.push_back(samples - length);
  return out;
}

std::vector<double> hann(std::size_t length) {
  std::vector<double> out(length);
  for (std::size_t i = 0; i < length; ++i)
    out[i] = 0.5 - 0.5 * elementary::cos(2 * std::numbers::pi * static_cast<double>(i) /
                                         static_cast<double>(length));
  return out;
}

/// Adds |DFT|² of one component of one piece at the frequencies 1, 2, ... of the piece.
void add_periodogram(std::span<const Vec3> piece, int component, const std::vector<double>& window,
                     std::vector<double>& power) {
  double mean = 0;
  for (const Vec3& x : piece) mean += x[component] / static_cast<double>(piece.size());
  std::vector<double> windowed(piece.size());
  for (std::size_t i = 0; i < piece.size(); ++i)
    windowed[i] = window[i] * (piece[i][component] - mean);
  const std::vector<std::complex<double>> transform = fourier_transform(windowed);
  for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(transform[k + 1]);
}

}  // namespace

double total_variation(std::span<const Vec3> x) {
  double sum = 0;
  for (std::size_t i = 1; i < x.size(); ++i) sum += (x[i] - x[i - 1]).norm();
  return sum;
}

Spectrum spectrum(std::span<const Vec3> x, double rate_hz) {
  Spectrum out;
  if (x.size() < 4) return out;
  const std::size_t length = piece_length(x.size(), rate_hz);
  const std::vector<double> window = hann(length);
  out.power.resize(length / 2);
  const auto begin = beginnings(x.size(), length);
  for (const std::size_t i : begin)
    for (int component = 0; component < 3; ++component)
      add_periodogram(x.subspan(i, length), component, window, out.power);
  double window_power = 0;
  for (const double w : window) window_power += w * w;
  const double n = static_cast<double>(length);
  for (std::size_t k = 0; k < out.power.size(); ++k) {
    const bool half_the_rate = 2 * (k + 1) == length;  // the Nyquist frequency has no mirror image
    out.power[k] *=
        (half_the_rate ? 1 : 2) / (n * window_power * static_cast<double>(begin.size()));
    out.frequency.push_back(static_cast<double>(k + 1) * rate_hz / n);
  }
  return out;
}

std::optional<double> share_above(const Spectrum& spectrum, double frequency) {
  if (spectrum.frequency.empty() || spectrum.frequency.back() <= frequency) return std::nullopt;
  double all = 0, above = 0;
  for (std::size_t k = 0; k < spectrum.power.size(); ++k) {
    all += spectrum.power[k];
    if (spectrum.frequency[k] > frequency) above += spectrum.power[k];
  }
  return all > 0 ? std::optional(above / all) : std::nullopt;
}

std::optional<double> sample_rate(std::span<const double> times) {
  if (times.size() < 2) return std::nullopt;
  const double step = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(std::abs(times[i] - times[i - 1] - step) <= 0.01 * step)) return std::nullopt;
  return 1 / step;
}

}  // namespace sonde
