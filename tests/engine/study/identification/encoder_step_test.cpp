// SPDX-License-Identifier: GPL-3.0-or-later
// References: steps that positions are rounded to here.
#include "engine/study/identification/encoder_step.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/geometry/random.hpp"

namespace sonde {
namespace {

/// A swing of 10 mm, rounded to a step, or exact where that is zero.
std::vector<double> swing(double step, double noise = 0) {
  Random random(1);
  std::vector<double> out;
  for (int i = 0; i < 400; ++i) {
    const double x = 0.01 * std::sin(0.05 * i) + 0.3;
    out.push_back((step == 0 ? x : std::round(x / step) * step) + noise * random.uniform(-1, 1));
  }
  return out;
}

TEST(EncoderStep, is_that_to_which_positions_were_rounded) {
  for (const double step : {2e-6, 3e-5, 5.5e-5, 1e-3}) {
    const auto found = encoder_step(swing(step));
    ASSERT_TRUE(found) << step;
    EXPECT_NEAR(found->value, step, 1e-6 * step);
    EXPECT_LE(found->low, step);
    EXPECT_GE(found->high, step);
  }
}

TEST(EncoderStep, is_found_where_no_change_is_of_one_step) {
  std::vector<double> positions{0};
  for (int i = 0; i < 40; ++i) positions.push_back(positions.back() + (i % 2 == 0 ? 2e-5 : 3e-5));
  const auto found = encoder_step(positions);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value, 1e-5, 1e-11);
}

TEST(EncoderStep, survives_single_precision) {
  std::vector<double> positions = swing(1e-5);
  for (double& x : positions) x = static_cast<double>(static_cast<float>(x));
  const auto found = encoder_step(positions);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value, 1e-5, 1e-3 * 1e-5);
  EXPECT_LE(found->low, 1e-5);
  EXPECT_GE(found->high, 1e-5);
}

TEST(EncoderStep, is_none_of_exact_positions_of_noise_and_of_a_few_changes) {
  EXPECT_FALSE(encoder_step(swing(0)));
  EXPECT_FALSE(encoder_step(swing(2e-5, 1e-5)));
  EXPECT_FALSE(encoder_step(std::vector<double>(100, 0.3)));
  EXPECT_FALSE(encoder_step(std::vector<double>{0, 1e-5, 2e-5, 1e-5}));
  EXPECT_FALSE(encoder_step({}));
}

}  // namespace
}  // namespace sonde
