// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/encoder_step.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/ordering.hpp"

namespace sonde {
namespace {

/// Fewer changes than this prove nothing.
constexpr std::size_t least_changes = 10;
/// Share of a step within which a change counts as a whole multiple; one in a hundred may lie
/// outside.
constexpr double tolerance = 0.02;
constexpr double nearly_every = 0.99;
/// Above this multiple, a slightly wrong step no longer distinguishes whole multiples from others.
constexpr double most_multiple = 1000;
/// The smallest change may be up to this many steps.
constexpr int most_in_smallest = 4;
/// Standard deviations of a mean of many values: 99 %.
constexpr double certain = 2.576;
/// For numbers that may have been written in single precision.
constexpr double rounding = 1e-6;

/// The sizes of the changes, sorted. Sizes far below the largest are rounding, and left out.
std::vector<double> changes(std::span<const double> positions) {
  std::vector<double> out;
  for (std::size_t i = 1; i < positions.size(); ++i)
    out.push_back(std::abs(positions[i] - positions[i - 1]));
  ordering::sort(out);
  const double nothing = out.empty() ? 0 : rounding * out.back();
  out.erase(out.begin(), std::ranges::upper_bound(out, nothing));
  return out;
}

/// A step near `guess`, fitted to the changes from small to large, so that the multiple of each is
/// certain before larger ones refine the step. None if too many are no whole multiples.
std::optional<Estimate> fitted(const std::vector<double>& sizes, double guess) {
  double step = guess, products = 0, squares = 0, sums = 0;
  std::size_t considered = 0, whole = 0;
  for (const double size : sizes) {
    const double multiple = std::round(size / step);
    if (multiple > most_multiple) break;
    ++considered;
    if (multiple < 1 || std::abs(size / step - multiple) > tolerance) continue;
    ++whole;
    products += multiple * size;
    squares += multiple * multiple;
    sums += size * size;
    step = products / squares;
  }
  const auto n = static_cast<double>(whole);
  if (n < nearly_every * static_cast<double>(considered)) return std::nullopt;
  const double left = std::max(0.0, sums - products * step) / n;
  const double half = certain * std::sqrt(left / squares) + rounding * step;
  return Estimate{step, step - half, step + half};
}

}  // namespace

std::optional<Estimate> encoder_step(std::span<const double> positions) {
  const std::vector<double> sizes = changes(positions);
  if (sizes.size() < least_changes) return std::nullopt;
  for (int n = 1; n <= most_in_smallest; ++n)
    if (const auto step = fitted(sizes, sizes.front() / n)) return step;
  return std::nullopt;
}

}  // namespace sonde
