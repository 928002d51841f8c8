// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/chatter.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

namespace sonde {
namespace {

/// The windowed signal of one coordinate.
std::vector<double> windowed(std::span<const Vec6> wrenches, Eigen::Index row) {
  std::vector<double> out(wrenches.size());
  const double turn = 2 * std::numbers::pi / double(out.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = wrenches[i][row] * (1 - std::cos(turn * double(i)));
  return out;
}

struct Power {
  double all = 0, slow = 0;
};

/// By Parseval: what is not below the frequency is above it.
Power power_of(const std::vector<double>& x, std::size_t slow_bins) {
  Power out;
  for (const double value : x) out.all += value * value;
  std::vector<std::complex<double>> transform;
  Eigen::FFT<double>().fwd(transform, x);
  for (std::size_t m = 0; m < slow_bins; ++m)
    out.slow += (m == 0 ? 1 : 2) * std::norm(transform[m]) / double(x.size());
  return out;
}

}  // namespace

double chatter_index(std::span<const Vec6> wrenches, double sample_time, double length) {
  if (wrenches.size() < 8) return 0;
  const double bins = std::ceil(chatter_frequency * sample_time * double(wrenches.size()));
  const auto slow_bins = std::min(static_cast<std::size_t>(bins), wrenches.size() / 2);
  Power sum;
  for (Eigen::Index row = 0; row < 6; ++row) {
    const Power own = power_of(windowed(wrenches, row), slow_bins);
    const double weight = row < 3 ? 1 : length > 0 ? 1 / (length * length) : 0;
    sum.all += weight * own.all;
    sum.slow += weight * own.slow;
  }
  return sum.all > 0 ? std::clamp((sum.all - sum.slow) / sum.all, 0.0, 1.0) : 0;
}

}  // namespace sonde
