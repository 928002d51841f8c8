// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: sums of sines, whose power in each frequency is half the square of the amplitude.
#include "engine/study/stability/chatter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace sonde {
namespace {

std::vector<Vec6> signal(double steady, double slow, double fast, double fast_hz, double torque) {
  std::vector<Vec6> out(1000, Vec6::Zero());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double turn = 2 * std::numbers::pi * double(i) * 1e-3;
    out[i][2] = steady + slow * std::sin(10 * turn) + fast * std::sin(fast_hz * turn);
    out[i][4] = torque * std::sin(fast_hz * turn);
  }
  return out;
}

TEST(Chatter, is_the_share_of_the_power_above_fifty_hertz) {
  for (const double fast_hz : {60.0, 127.3, 250.0, 400.0})
    for (const double fast : {0.0, 0.05, 1.0}) {
      const double share = fast * fast / 2 / (9 + 0.5 + fast * fast / 2);
      EXPECT_NEAR(chatter_index(signal(3, 1, fast, fast_hz, 0), 1e-3, 0.1), share,
                  0.01 * share + 1e-6)
          << fast_hz << ' ' << fast;
    }
  EXPECT_LT(chatter_index(signal(3, 1, 1, 40, 0), 1e-3, 0.1), 1e-6);
}

TEST(Chatter, torques_count_by_the_length) {
  // 0.1 N·m at 5 cm is 2 N.
  EXPECT_NEAR(chatter_index(signal(3, 0, 0, 100, 0.1), 1e-3, 0.05), 2.0 / (9 + 2.0), 1e-3);
}

TEST(Chatter, drift_is_none) {
  std::vector<Vec6> wrenches(1000, Vec6::Zero());
  for (std::size_t i = 0; i < wrenches.size(); ++i) wrenches[i][0] = 1 + double(i) * 1e-3;
  EXPECT_LT(chatter_index(wrenches, 1e-3, 0.1), 1e-7);
  EXPECT_EQ(chatter_index({}, 1e-3, 0.1), 0);
  EXPECT_EQ(chatter_index(std::vector<Vec6>(100, Vec6::Zero()), 1e-3, 0.1), 0);
}

}  // namespace
}  // namespace sonde
