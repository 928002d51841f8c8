// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/pair.hpp"

#include <gtest/gtest.h>

#include <random>
#include <utility>

#include "engine/proximity/sketch/sketch.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

TEST(Pair, has_sketches_wherever_there_can_be_any) {
  std::mt19937_64 random(1);
  const auto solid = test::body(test::box({0.1, 0.2, 0.3}));
  const auto soup = test::body(test::random_soup(random, 10, 0.2));
  EXPECT_TRUE(Pair(solid, solid).sketches());
  EXPECT_TRUE(Pair(solid, soup).sketches());
  EXPECT_TRUE(Pair(soup, solid).sketches());
  EXPECT_FALSE(Pair(soup, soup).sketches());
}

TEST(Pair, keeps_its_bodies_and_shares_what_it_made) {
  auto probe = test::body(test::box({0.1, 0.2, 0.3})), fixed = test::body(test::box({1, 1, 1}));
  const Body* const a = probe.get();
  const Body* const b = fixed.get();
  Pair pair(std::move(probe), std::move(fixed));
  EXPECT_EQ(&pair.probe(), a);
  EXPECT_EQ(&pair.fixed(), b);
  // Nothing moves from a pair. NOLINTNEXTLINE(performance-move-const-arg)
  const Pair copy = std::move(pair);
  // NOLINTNEXTLINE(bugprone-use-after-move)
  EXPECT_EQ(&pair.probe(), &copy.probe());
  EXPECT_EQ(&pair.sketches(), &copy.sketches());
}

TEST(Pair, without_a_body_there_is_none) {
  const auto body = test::body(test::box({1, 1, 1}));
  EXPECT_THROW(Pair(nullptr, body), InputError);
  EXPECT_THROW(Pair(body, nullptr), InputError);
}

}  // namespace
}  // namespace sonde
