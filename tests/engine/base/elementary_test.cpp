// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is MPFR, which rounds right by proof. The values are the nearest doubles to the
// true ones but for those that lie within some 2^-14 of a unit in the last place of the middle
// between two doubles.
#include "engine/base/elementary.hpp"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "engine/base/numbers.hpp"

namespace sonde {
namespace {

using OfOne = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using OfTwo = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

/// A number of MPFR with `bits` bits.
class Exact {
 public:
  explicit Exact(int bits, double x = 0) {
    mpfr_init2(number_, bits);
    mpfr_set_d(number_, x, MPFR_RNDN);
  }
  ~Exact() { mpfr_clear(number_); }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  mpfr_ptr get() { return number_; }

 private:
  mpfr_t number_;
};

double rounded(OfOne f, double x) {
  Exact in(53, x), out(53);
  f(out.get(), in.get(), MPFR_RNDN);
  return mpfr_get_d(out.get(), MPFR_RNDN);
}

double rounded(OfTwo f, double x, double y) {
  Exact first(53, x), second(53, y), out(53);
  f(out.get(), first.get(), second.get(), MPFR_RNDN);
  return mpfr_get_d(out.get(), MPFR_RNDN);
}

bool same(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) ||
         (std::isnan(x) && std::isnan(y));
}

bool are_neighbours(double x, double y) { return std::nextafter(x, y) == y; }

/// Bits of a Mersenne twister, whose numbers the standard lays down.
class Numbers {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  /// Of any size between 2^low and 2^high.
  double of_size(double low, double high) {
    const int power = static_cast<int>(std::floor(between(low, high)));
    return std::ldexp(between(1, 2), power);
  }
  double of_either_sign(double x) { return bits_() % 2 == 0 ? x : -x; }

 private:
  std::mt19937_64 bits_{1};
};

constexpr int samples = 40'000;
/// So many of the samples may be the other neighbour.
constexpr int few = 8;

void expect_right(double (*f)(double) noexcept, OfOne exact, const std::function<double()>& x) {
  int others = 0;
  for (int i = 0; i < samples; ++i) {
    const double at = x(), got = f(at), want = rounded(exact, at);
    if (same(got, want)) continue;
    ++others;
    EXPECT_TRUE(are_neighbours(got, want)) << std::hexfloat << at << ": " << got << ", " << want;
  }
  EXPECT_LE(others, few);
}

void expect_right(double (*f)(double, double) noexcept, OfTwo exact,
                  const std::function<double()>& x, const std::function<double()>& y) {
  int others = 0;
  for (int i = 0; i < samples; ++i) {
    const double a = x(), b = y(), got = f(a, b), want = rounded(exact, a, b);
    if (same(got, want)) continue;
    ++others;
    EXPECT_TRUE(are_neighbours(got, want))
        << std::hexfloat << a << ", " << b << ": " << got << ", " << want;
  }
  EXPECT_LE(others, few);
}

TEST(Elementary, circular_functions_round_right) {
  Numbers random;
  const auto turn = [&] { return random.between(-7, 7); };
  const auto small = [&] { return random.of_either_sign(random.of_size(-60, 1)); };
  const auto large = [&] { return random.of_either_sign(random.of_size(1, 20)); };
  for (const std::function<double()>& x :
       {std::function<double()>(turn), std::function<double()>(small),
        std::function<double()>(large)}) {
    expect_right(elementary::sin, mpfr_sin, x);
    expect_right(elementary::cos, mpfr_cos, x);
    expect_right(elementary::tan, mpfr_tan, x);
  }
}

TEST(Elementary, near_whole_quarters_of_a_turn_too) {
  int quarter = 0;
  const auto x = [&] { return static_cast<double>(++quarter) * std::acos(0.0); };
  expect_right(elementary::sin, mpfr_sin, x);
  quarter = 0;
  expect_right(elementary::cos, mpfr_cos, x);
}

TEST(Elementary, arcs_round_right) {
  Numbers random;
  const auto any = [&] { return random.of_either_sign(random.of_size(-40, 40)); };
  const auto alike = [&] { return random.between(-1, 1); };
  expect_right(elementary::atan2, mpfr_atan2, any, any);
  expect_right(elementary::atan2, mpfr_atan2, alike, alike);
  expect_right(elementary::acos, mpfr_acos, alike);
  expect_right(elementary::acos, mpfr_acos,
               [&] { return random.of_either_sign(1 - random.of_size(-52, -1)); });
}

TEST(Elementary, exponentials_and_logarithms_round_right) {
  Numbers random;
  const auto exponent = [&] { return random.between(-708, 709.7); };
  const auto small = [&] { return random.of_either_sign(random.of_size(-60, 2)); };
  const auto any = [&] { return random.of_size(-1000, 1000); };
  const auto near_one = [&] { return 1 + random.of_either_sign(random.of_size(-52, -1)); };
  expect_right(elementary::exp, mpfr_exp, exponent);
  expect_right(elementary::exp, mpfr_exp, small);
  expect_right(elementary::expm1, mpfr_expm1, exponent);
  expect_right(elementary::expm1, mpfr_expm1, small);
  expect_right(elementary::log, mpfr_log, any);
  expect_right(elementary::log, mpfr_log, near_one);
  expect_right(elementary::log10, mpfr_log10, any);
  expect_right(elementary::log1p, mpfr_log1p, [&] { return random.of_size(-60, 60); });
  expect_right(elementary::log1p, mpfr_log1p, [&] { return -random.of_size(-60, -1); });
}

TEST(Elementary, powers_and_hypotenuses_round_right) {
  Numbers random;
  expect_right(
      elementary::pow, mpfr_pow, [&] { return random.of_size(-20, 20); },
      [&] { return random.between(-40, 40); });
  const auto any = [&] { return random.of_either_sign(random.of_size(-1000, 1000)); };
  const auto alike = [&] { return random.between(-1, 1); };
  expect_right(elementary::hypot, mpfr_hypot, any, any);
  expect_right(elementary::hypot, mpfr_hypot, alike, alike);
}

TEST(Elementary, whole_powers_of_ten_are_whole) {
  double ten = 1;
  for (int n = 0; n <= 22; ++n, ten *= 10) {
    EXPECT_EQ(elementary::log10(ten), n);
    EXPECT_EQ(elementary::pow(10, n), ten);
  }
}

/// All pairs of these, beside the C library, whose answers to them are the standard's. Of one
/// number only those whose answers are exact or an angle.
TEST(Elementary, zeros_infinities_and_their_signs_are_as_c_says) {
  const std::vector<double> values = {0.0,       -0.0,      1,     -1,     infinity,
                                      -infinity, no_number, 1e300, 5e-324, -5e-324};
  for (const double x : values) {
    for (const double y : values) {
      EXPECT_TRUE(same(elementary::atan2(y, x), std::atan2(y, x))) << y << ", " << x;
      EXPECT_TRUE(same(elementary::hypot(y, x), std::hypot(y, x))) << y << ", " << x;
      if (!std::signbit(x)) {
        EXPECT_TRUE(same(elementary::pow(x, y), std::pow(x, y))) << x << ", " << y;
      }
    }
    if (std::abs(x) == 1) continue;
    for (const auto& [f, c] :
         std::vector<std::pair<double (*)(double) noexcept, double (*)(double)>>{
             {elementary::exp, std::exp},
             {elementary::expm1, std::expm1},
             {elementary::log, std::log},
             {elementary::log10, std::log10},
             {elementary::log1p, std::log1p},
             {elementary::acos, std::acos},
             {elementary::sin, std::sin},
             {elementary::cos, std::cos},
             {elementary::tan, std::tan}})
      EXPECT_TRUE(same(f(x), c(x))) << x << ": " << f(x) << ", " << c(x);
  }
}

/// Twice rounded on every processor: contracted, it would be 2^-54.
TEST(Elementary, products_are_rounded_before_they_are_added) {
  volatile double x = 1 + 0x1p-27;
  EXPECT_EQ(x * x - (1 + 0x1p-26), 0);
}

}  // namespace
}  // namespace sonde
