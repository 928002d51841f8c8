// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is the definition, counted out: how many values are not above.
#include "engine/base/quantile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sonde {
namespace {

TEST(Quantile, is_the_least_value_that_the_share_does_not_exceed) {
  for (const std::size_t n : {1u, 2u, 3u, 10u, 101u}) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) values.push_back(static_cast<double>(i * i));
    for (const double share : {0.0, 0.1, 0.25, 0.5, 0.9, 0.99, 1.0}) {
      const double got = quantile(values, share);
      const auto up_to = [&](double x) {
        return static_cast<double>(std::ranges::upper_bound(values, x) - values.begin());
      };
      EXPECT_GE(up_to(got), share * static_cast<double>(n)) << n << ", " << share;
      if (got == values.front()) continue;  // there is no lesser one
      EXPECT_LT(up_to(got - 1e-9), share * static_cast<double>(n)) << n << ", " << share;
    }
  }
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

}  // namespace
}  // namespace sonde
