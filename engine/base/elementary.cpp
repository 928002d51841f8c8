// SPDX-License-Identifier: GPL-3.0-or-later
// Each function is a series in pairs of doubles on a short interval. Terms below 2^-18 of the sum
// are computed in doubles, so that some 70 bits of the sum are right.
#include "engine/base/elementary.hpp"

#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/base/number_pair.hpp"
#include "engine/base/numbers.hpp"

#ifdef __FAST_MATH__
#error "-ffast-math breaks the rounding that every answer relies on"
#endif
static_assert(FLT_EVAL_METHOD == 0, "doubles must be rounded to doubles: on 32-bit x86, use SSE2");

namespace sonde::elementary {
namespace {

constexpr NumberPair one{1, 0};
constexpr NumberPair pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};
constexpr NumberPair half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

constexpr double factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/// first[0] + x (first[1] + x (... + x (rest[0] + x.high (rest[1] + ...)))).
template <std::size_t N, std::size_t M>
NumberPair series(NumberPair x, const std::array<NumberPair, N>& first,
                  const std::array<double, M>& rest) {
  double tail = 0;
  for (std::size_t i = M; i-- > 0;) tail = rest[i] + x.high * tail;
  NumberPair sum = first[N - 1] + tail * x;
  for (std::size_t i = N - 1; i-- > 0;) sum = first[i] + x * sum;
  return sum;
}

/// ±1/(2k + odd)! from k = `from` on, alternating.
template <std::size_t N>
constexpr std::array<NumberPair, N> circular(int odd, int from) {
  std::array<NumberPair, N> out;
  for (std::size_t i = 0; i < N; ++i) {
    const int k = from + static_cast<int>(i);
    out[i] = one_over((k % 2 == 0 ? 1 : -1) * factorial(2 * k + odd));
  }
  return out;
}

template <std::size_t N>
constexpr std::array<double, N> rounded(const std::array<NumberPair, N>& pairs) {
  std::array<double, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = pairs[i].high;
  return out;
}

NumberPair sine_of(NumberPair x) {
  static constexpr auto first = circular<3>(1, 1);
  static constexpr auto rest = rounded(circular<7>(1, 4));
  const NumberPair square = x * x;
  return x + x * square * series(square, first, rest);
}

NumberPair cosine_of(NumberPair x) {
  static constexpr auto first = circular<3>(0, 1);
  static constexpr auto rest = rounded(circular<7>(0, 4));
  const NumberPair square = x * x;
  return one + square * series(square, first, rest);
}

/// x - quarters·π/2, within ±π/4; quarters modulo 4.
struct Turned {
  NumberPair rest;
  int quarters;
};

constexpr double largest_angle = 0x1p20;

/// The integer nearest to x, for |x| < 2^51.
double nearest(double x) { return (x + 0x1.8p52) - 0x1.8p52; }

/// Subtracts n·(parts[0] + parts[1] + ...) from x. The products of all parts but the last are
/// exact.
template <std::size_t N>
NumberPair reduced(double x, double n, const std::array<double, N>& parts) {
  NumberPair at{x, 0};
  double low = 0;
  for (std::size_t i = 0; i + 1 < N; ++i) {
    at = exact_sum(at.high, -n * parts[i]);
    low += at.low;
  }
  return exact_sum(at.high, low - n * parts[N - 1]);
}

Turned turned(double x) {
  static constexpr std::array<double, 4> parts = {0x1.921fb544p+0, 0x1.0b4611a6p-34,
                                                  0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
  const double n = nearest(x * 0x1.45f306dc9c883p-1);
  return {reduced(x, n, parts), static_cast<int>(n) & 3};
}

/// Whether only the first term of the sine's series matters in double precision.
bool is_tiny(double x) { return std::abs(x) < 0x1p-27; }

/// exp(x) = 2^power·(1 + rest).
struct Exponential {
  NumberPair rest;
  int power;
};

constexpr std::array<double, 3> ln2 = {0x1.62e42fefa38p-1, 0x1.ef35793c76p-45,
                                       0x1.cc01f97b57a08p-87};

template <std::size_t N>
constexpr std::array<NumberPair, N> inverse_factorials(int from) {
  std::array<NumberPair, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = one_over(factorial(from + static_cast<int>(i)));
  return out;
}

Exponential exponential(NumberPair x) {
  static constexpr auto first = inverse_factorials<6>(1);
  static constexpr auto rest = rounded(inverse_factorials<11>(7));
  const double n = nearest(x.high * 0x1.71547652b82fep+0);
  const NumberPair r = reduced(x.high, n, ln2) + NumberPair{x.low, 0};
  return {r * series(r, first, rest), static_cast<int>(n)};
}

/// exp(x) for an x at which it certainly overflows or underflows.
double beyond(double x) { return x > 0 ? infinity : 0; }
constexpr double largest_exponent = 746;

double exponential_of(NumberPair x) {
  const Exponential e = exponential(x);
  return std::ldexp((one + e.rest).high, e.power);
}

template <std::size_t N>
constexpr std::array<NumberPair, N> inverse_odd(int from) {
  std::array<NumberPair, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = one_over(2 * (from + static_cast<int>(i)) + 1);
  return out;
}

/// For a finite x > 0, by the inverse hyperbolic tangent of (m - 1)/(m + 1), x = 2^e·m.
NumberPair logarithm(NumberPair x) {
  static constexpr auto first = inverse_odd<3>(1);
  static constexpr auto rest = rounded(inverse_odd<11>(4));
  int e = 0;
  double m = std::frexp(x.high, &e);
  if (m < 0.70710678118654752) {
    m *= 2;
    --e;
  }
  const NumberPair scaled{m, std::ldexp(x.low, -e)};
  const NumberPair ratio = (scaled + NumberPair{-1, 0}) / (scaled + one), square = ratio * ratio;
  const NumberPair half = ratio + ratio * square * series(square, first, rest);
  const NumberPair of_m{2 * half.high, 2 * half.low};
  if (e == 0) return of_m;
  return -reduced(0, e, ln2) + of_m;
}

/// The angle in [0, π/2] whose tangent is y/x, for y, x ≥ 0, of which the larger is near 1.
NumberPair first_quadrant(NumberPair y, NumberPair x) {
  // atan(k/16)
  static constexpr std::array<NumberPair, 17> steps = {{
      {0x0.0p+0, 0x0.0p+0},
      {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
      {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
      {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
      {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
      {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
      {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
      {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
      {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
      {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
      {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
      {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
      {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
      {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
      {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
      {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
      {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
  }};
  static constexpr std::array<NumberPair, 1> first = {-one_over(3)};
  static constexpr std::array<double, 6> rest = {1.0 / 5,   -1.0 / 7, 1.0 / 9,
                                                 -1.0 / 11, 1.0 / 13, -1.0 / 15};
  if (y.high > x.high) return half_pi + -first_quadrant(x, y);
  const double step = nearest(16 * (y.high / x.high)), tangent = step / 16;
  const NumberPair t = (y + -tangent * x) / (x + tangent * y), square = t * t;
  return steps[static_cast<std::size_t>(step)] + (t + t * square * series(square, first, rest));
}

/// 1 if x is infinite, otherwise 0: its direction compared with a finite number.
double as_direction(double x) { return std::isinf(x) ? 1 : 0; }

double arc(double y, double x) {
  if (y == 0) return std::signbit(x) ? pi.high : y;
  if (std::isinf(y) || std::isinf(x)) {
    const double up = as_direction(y), along = as_direction(x);
    return arc(up, std::signbit(x) ? -along : along);
  }
  int of_y = 0, of_x = 0;
  std::frexp(y, &of_y);
  std::frexp(x, &of_x);
  if (x > 0 && of_y - of_x < -60) return y / x;
  const int largest = x == 0 || of_y > of_x ? of_y : of_x;
  const NumberPair angle =
      first_quadrant({std::ldexp(y, -largest), 0}, {std::ldexp(std::abs(x), -largest), 0});
  return std::signbit(x) ? (pi + -angle).high : angle.high;
}

NumberPair square_root(NumberPair x) {
  const double root = std::sqrt(x.high);
  const NumberPair left = x + -exact_product(root, root);
  return quick_sum(root, left.high / (2 * root));
}

}  // namespace

double sin(double x) noexcept {
  if (!(std::abs(x) < largest_angle)) return std::sin(x);
  if (is_tiny(x)) return x;
  const Turned at = turned(x);
  const double value = (at.quarters % 2 == 0 ? sine_of(at.rest) : cosine_of(at.rest)).high;
  return at.quarters < 2 ? value : -value;
}

double cos(double x) noexcept {
  if (!(std::abs(x) < largest_angle)) return std::cos(x);
  const Turned at = turned(x);
  const double value = (at.quarters % 2 == 0 ? cosine_of(at.rest) : sine_of(at.rest)).high;
  return at.quarters == 0 || at.quarters == 3 ? value : -value;
}

double tan(double x) noexcept {
  if (!(std::abs(x) < largest_angle)) return std::tan(x);
  if (is_tiny(x)) return x;
  const Turned at = turned(x);
  const NumberPair sine = sine_of(at.rest), cosine = cosine_of(at.rest);
  return at.quarters % 2 == 0 ? (sine / cosine).high : -(cosine / sine).high;
}

double atan2(double y, double x) noexcept {
  if (std::isnan(x) || std::isnan(y)) return no_number;
  return std::signbit(y) ? -arc(-y, x) : arc(y, x);
}

double acos(double x) noexcept {
  if (!(std::abs(x) <= 1)) return no_number;
  if (std::abs(x) == 1) return x > 0 ? 0 : pi.high;
  const NumberPair height = square_root(exact_sum(1, -x) * exact_sum(1, x));
  const NumberPair angle = first_quadrant(height, {std::abs(x), 0});
  return x < 0 ? (pi + -angle).high : angle.high;
}

double exp(double x) noexcept {
  if (std::isnan(x)) return x;
  if (std::abs(x) > largest_exponent) return beyond(x);
  return exponential_of({x, 0});
}

double expm1(double x) noexcept {
  if (std::abs(x) < 0x1p-54) return x;
  if (!(std::abs(x) < 100)) return exp(x) - 1;  // the one is below half a unit of it, or it of one
  const Exponential e = exponential({x, 0});
  const double scale = std::ldexp(1.0, e.power);
  return (scale * e.rest + exact_sum(scale, -1)).high;
}

double log(double x) noexcept {
  if (!(x > 0)) return x == 0 ? -infinity : no_number;
  if (std::isinf(x)) return x;
  return logarithm({x, 0}).high;
}

double log1p(double x) noexcept {
  if (!(x > -1)) return x == -1 ? -infinity : no_number;
  if (std::isinf(x) || std::abs(x) < 0x1p-54) return x;
  return logarithm(exact_sum(1, x)).high;
}

double log10(double x) noexcept {
  if (!(x > 0) || std::isinf(x)) return log(x);
  constexpr NumberPair per_decade{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
  return (logarithm({x, 0}) * per_decade).high;
}

double pow(double x, double y) noexcept {
  if (y == 0 || x == 1) return 1;
  if (!(x >= 0) || std::isnan(y)) return no_number;
  if (x == 0 || std::isinf(x)) return (x == 0) == (y > 0) ? 0 : infinity;
  const NumberPair of_x = logarithm({x, 0});
  const double about = y * of_x.high;
  if (std::abs(about) > largest_exponent) return beyond(about);
  if (std::abs(about) < 0x1p-54) return 1;
  return exponential_of(y * of_x);
}

double hypot(double x, double y) noexcept {
  if (std::isinf(x) || std::isinf(y)) return infinity;
  if (std::isnan(x) || std::isnan(y)) return no_number;
  const double largest = std::fmax(std::abs(x), std::abs(y));
  if (largest == 0) return 0;
  int power = 0;
  std::frexp(largest, &power);
  const double a = std::ldexp(x, -power), b = std::ldexp(y, -power);
  return std::ldexp(square_root(exact_product(a, a) + exact_product(b, b)).high, power);
}

}  // namespace sonde::elementary
