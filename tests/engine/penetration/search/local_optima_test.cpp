// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/local_optima.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sonde {
namespace {

LocalOptimum place(double depth, int axis, int starts = 1) {
  return {.y = depth * Vec6::Unit(axis), .depth = depth, .starts = starts};
}

TEST(LocalOptima, the_nearest_come_first_and_each_place_once) {
  LocalOptima places;
  EXPECT_TRUE(places.empty());
  places.add(place(3, 0));
  places.add(place(1, 1));
  places.add(place(1.01, 1));  // the same place
  places.add(place(1.01, 2));  // as far away, but elsewhere
  EXPECT_EQ(places.best(), 1);
  const std::vector<Vec6> all = places.nearest(9);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0], Vec6(Vec6::Unit(1)));
  EXPECT_EQ(all[1], Vec6(1.01 * Vec6::Unit(2)));
  EXPECT_EQ(all[2], Vec6(3 * Vec6::Unit(0)));
  EXPECT_EQ(places.nearest(1).size(), 1U);
}

TEST(LocalOptima, starts_agree_until_something_better_is_found) {
  LocalOptima places;
  places.add(place(1, 0, 3));
  places.add(place(1.01, 1));
  places.add(place(1.5, 2));    // ended elsewhere
  places.add(place(1, 3, 0));   // knew where to look
  places.add(place(0.995, 4));  // better by so little that it is the same depth
  EXPECT_EQ(places.agreeing(), 5);
  places.add(place(0.5, 5, 2));
  EXPECT_EQ(places.agreeing(), 2);
}

TEST(LocalOptima, steps_to_something_better_do_not_agree_with_each_other) {
  LocalOptima places;
  double depth = 1;
  for (int i = 0; i < 12; ++i, depth *= 0.985) places.add(place(depth, i % 6));
  EXPECT_EQ(places.agreeing(), 2);  // the last two are within 2 %
}

TEST(LocalOptima, what_led_nowhere_does_not_count) {
  LocalOptima places;
  places.add(LocalOptimum{});
  EXPECT_TRUE(places.empty());
  EXPECT_TRUE(std::isinf(places.best()));
  EXPECT_EQ(places.agreeing(), 0);
}

TEST(LocalOptima, what_is_near_the_best_is_known) {
  LocalOptima places;
  EXPECT_FALSE(places.is_known(Vec6::Zero(), 0.1));
  places.add(place(2, 0));
  places.add(place(1, 1));
  EXPECT_TRUE(places.is_known(1.05 * Vec6::Unit(1), 0.1));
  EXPECT_FALSE(places.is_known(1.15 * Vec6::Unit(1), 0.1));
  EXPECT_FALSE(places.is_known(2 * Vec6::Unit(0), 0.1)) << "only the best counts";
}

}  // namespace
}  // namespace sonde
