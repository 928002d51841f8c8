// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is the definition, summed in long double.
#include "engine/study/parts/fourier.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/random.hpp"

namespace sonde {
namespace {

TEST(Fourier, is_its_definition_at_any_length) {
  EXPECT_TRUE(fourier_transform({}).empty());
  Random random(1);
  for (const std::size_t n : {1u, 2u, 3u, 4u, 7u, 16u, 60u, 97u, 128u, 315u, 1000u}) {
    std::vector<double> x(n);
    for (double& each : x) each = random.uniform(-1, 1);
    const auto got = fourier_transform(x);
    ASSERT_EQ(got.size(), n);
    for (std::size_t k = 0; k < n; ++k) {
      long double real = 0, imaginary = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const long double angle = -2 * std::numbers::pi_v<long double> *
                                  static_cast<long double>(i * k % n) / static_cast<long double>(n);
        real += static_cast<long double>(x[i]) * std::cos(angle);
        imaginary += static_cast<long double>(x[i]) * std::sin(angle);
      }
      EXPECT_NEAR(got[k].real(), static_cast<double>(real), 1e-13 * std::sqrt(double(n)));
      EXPECT_NEAR(got[k].imag(), static_cast<double>(imaginary), 1e-13 * std::sqrt(double(n)));
    }
  }
}

TEST(Fourier, of_several_signals_of_one_length_is_that_of_each) {
  Random random(2);
  const FourierTransform transform(300);
  for (int i = 0; i < 3; ++i) {
    std::vector<double> x(300);
    for (double& each : x) each = random.uniform(-1, 1);
    EXPECT_EQ(transform(x), fourier_transform(x));
  }
}

}  // namespace
}  // namespace sonde
