// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/recent.hpp"

#include <gtest/gtest.h>

#include <random>

namespace sonde {
namespace {

// Reference: the function itself, at numbers that share places and at the largest.
TEST(Recent, gives_what_the_function_gives) {
  Recent<std::uint64_t, 8> recent;
  std::mt19937_64 random(1);
  const auto square = [](std::uint32_t n) { return std::uint64_t{n} * n; };
  for (int i = 0; i < 10000; ++i) {
    const auto step = static_cast<std::uint32_t>(random() % 30);
    const std::uint32_t n = i % 2 == 0 ? step : 0xfffffffeu - step;
    EXPECT_EQ(recent.at(n, square), square(n));
  }
}

TEST(Recent, makes_what_is_asked_for_again_once) {
  Recent<int, 8> recent;
  int made = 0;
  const auto make = [&](std::uint32_t n) { return ++made, static_cast<int>(n); };
  for (int round = 0; round < 5; ++round)
    for (std::uint32_t n = 16; n < 24; ++n) recent.at(n, make);
  EXPECT_EQ(made, 8);
}

}  // namespace
}  // namespace sonde
