// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/neighbour_reach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace sonde {
namespace {

constexpr double radius = 1, wanted = 1e-4;  // m
constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();

/// Work of a list where so much is spent however little it reaches, and the rest goes by the square
/// of the reach, as the pairs about a point of contact do.
std::int64_t work(double at_least, double reach) {
  return static_cast<std::int64_t>(at_least + 2e9 * reach * reach);
}

/// The reaches chosen one after the other.
std::vector<double> chosen(double at_least, int lists, std::int64_t affordable = unlimited) {
  NeighbourReach reach(radius);
  std::vector<double> out;
  for (int i = 0; i < lists; ++i) {
    out.push_back(reach.choose(wanted));
    reach.learn(wanted, out.back(), true, work(at_least, out.back()), affordable);
  }
  return out;
}

/// Reference: all reaches tried, for the cost that the class states.
double best_reach(double at_least) {
  double best = 0, least = std::numeric_limits<double>::infinity();
  for (double r = 1.5 * wanted; r < 32 * wanted; r *= 1.01)
    if (const double cost = std::pow(static_cast<double>(work(at_least, r)), 1.5) / (r - wanted);
        cost < least)
      least = cost, best = r;
  return best;
}

TEST(NeighbourReach, settles_about_the_reach_that_costs_least) {
  for (const double at_least : {100.0, 1e3, 1e4}) {
    const std::vector<double> all = chosen(at_least, 60);
    const double best = best_reach(at_least);
    // To and fro by a factor of 1.2, and one more before it is noticed.
    for (std::size_t i = 40; i < all.size(); ++i) {
      EXPECT_GT(all[i], best / 1.8) << at_least;
      EXPECT_LT(all[i], best * 1.8) << at_least;
    }
  }
}

TEST(NeighbourReach, what_costs_much_however_little_it_reaches_reaches_far) {
  EXPECT_GT(chosen(1e6, 60).back(), 2 * chosen(1e2, 60).back());
}

TEST(NeighbourReach, shrinks_to_what_is_affordable) {
  const std::int64_t affordable = work(100, 4 * wanted);
  const std::vector<double> all = chosen(100, 60, affordable);
  EXPECT_LT(work(100, *std::min_element(all.end() - 10, all.end())), affordable);
}

TEST(NeighbourReach, what_does_not_fit_shrinks_and_is_given_up_and_tried_again_some_time) {
  NeighbourReach reach(radius);
  const double long_path = 0.01 * radius;
  EXPECT_FALSE(reach.is_too_far(long_path));
  int lists = 0;
  for (; lists < 100 && !reach.is_too_far(long_path); ++lists)
    reach.learn(long_path, reach.choose(long_path), false, 0, unlimited);
  EXPECT_LT(lists, 10);
  EXPECT_FALSE(reach.is_too_far(1e-3 * 0.9 * radius)) << "short ones are always listed";
  int ticks = 0;
  while (ticks < 1000 && reach.is_too_far(long_path)) ++ticks;
  EXPECT_LT(ticks, 1000);
}

TEST(NeighbourReach, what_costs_much_more_than_others_of_late_is_left) {
  NeighbourReach reach(radius);
  reach.learn(wanted, NeighbourReach::least(wanted), true, 100'000, unlimited);
  EXPECT_GT(reach.most_work(), 100'000) << "no list is cheaper here";
  EXPECT_LT(reach.most_work(), 200'000);
  for (int i = 0; i < 10; ++i) reach.learn(wanted, 4 * wanted, true, 1000, unlimited);
  EXPECT_LT(reach.most_work(), 10'000);
  EXPECT_GT(reach.most_work(), 1000);
}

TEST(NeighbourReach, outlasts_the_step_it_is_made_for) {
  NeighbourReach reach(radius);
  for (int i = 0; i < 40; ++i) {
    const double chosen = reach.choose(wanted);
    EXPECT_GE(chosen, 1.5 * wanted);
    reach.learn(wanted, chosen, i % 3 != 0, 1 << 20, 1);
  }
}

}  // namespace
}  // namespace sonde
