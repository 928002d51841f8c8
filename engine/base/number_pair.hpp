// SPDX-License-Identifier: GPL-3.0-or-later
// A number as the sum of two doubles, the second below half a unit in the last place of the first:
// some 104 bits (Dekker, 1971; Joldes, Muller and Popescu, 2017). Without FMA, so that each
// operation is the same on every processor. Correct only if no product overflows or underflows:
// callers must scale their arguments.
#pragma once

namespace sonde {

struct NumberPair {
  double high = 0, low = 0;
};

/// x + y without error, where |x| ≥ |y| or x is 0.
constexpr NumberPair quick_sum(double x, double y) {
  const double sum = x + y;
  return {sum, y - (sum - x)};
}

/// x + y without error.
constexpr NumberPair exact_sum(double x, double y) {
  const double sum = x + y, of_y = sum - x;
  return {sum, (x - (sum - of_y)) + (y - of_y)};
}

/// x·y without error.
constexpr NumberPair exact_product(double x, double y) {
  constexpr double halves = 0x1p27 + 1;
  const double cut_x = halves * x, cut_y = halves * y;
  const double x1 = cut_x - (cut_x - x), x2 = x - x1;
  const double y1 = cut_y - (cut_y - y), y2 = y - y1;
  const double product = x * y;
  return {product, ((x1 * y1 - product) + x1 * y2 + x2 * y1) + x2 * y2};
}

constexpr NumberPair operator-(NumberPair x) { return {-x.high, -x.low}; }

constexpr NumberPair operator+(NumberPair x, NumberPair y) {
  const NumberPair high = exact_sum(x.high, y.high), low = exact_sum(x.low, y.low);
  const NumberPair sum = quick_sum(high.high, high.low + low.high);
  return quick_sum(sum.high, sum.low + low.low);
}

constexpr NumberPair operator*(NumberPair x, NumberPair y) {
  const NumberPair product = exact_product(x.high, y.high);
  return quick_sum(product.high, product.low + (x.high * y.low + x.low * y.high));
}

constexpr NumberPair operator*(double x, NumberPair y) { return NumberPair{x, 0} * y; }

constexpr NumberPair operator/(NumberPair x, NumberPair y) {
  const double first = x.high / y.high;
  const NumberPair left = x + -(first * y);
  return quick_sum(first, left.high / y.high);
}

/// 1/n, for the coefficients of series.
constexpr NumberPair one_over(double n) { return NumberPair{1, 0} / NumberPair{n, 0}; }

}  // namespace sonde
