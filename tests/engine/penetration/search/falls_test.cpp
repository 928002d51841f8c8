// SPDX-License-Identifier: GPL-3.0-or-later
// The reference of each test is the geometry that it describes: a wall, a slope or a ledge, for
// which depth and energy are known in closed form.
#include "engine/penetration/search/falls.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sonde {
namespace {

constexpr double clearance = 1e-7;  // m

/// The device moves by `by` (m, out of the wall if negative) while the probe stays on it.
Falls::Tick against_a_wall(double before, double by, bool converged = true) {
  return {.moved = std::abs(by),
          .before = before,
          .depth = before + by,
          .clearance = clearance,
          .converged = converged};
}

/// The probe comes down from `before` to `depth` (m), towards a device that moves by `moved`
/// across that way.
Falls::Tick down(double before, double depth, double moved, bool converged = true) {
  return {.moved = moved,
          .way = before - depth,
          .before = before,
          .depth = depth,
          .clearance = clearance,
          .let_go = before * before - depth * depth,
          .converged = converged};
}

TEST(Falls, what_is_held_by_a_wall_lets_nothing_go) {
  Falls falls(Method::pdg);
  for (const double by : {1e-5, -1e-5, 1e-3, -1e-3})
    EXPECT_FALSE(falls.released(against_a_wall(2e-3, by))) << by;
}

TEST(Falls, a_depth_that_falls_by_more_than_the_device_moves_has_jumped) {
  for (const Method method : {Method::pdg, Method::pdt}) {
    Falls falls(method);
    const Falls::Tick tick = down(2e-3, 1e-3, 1e-5);
    EXPECT_EQ(falls.released(tick), tick.let_go);
  }
}

TEST(Falls, so_has_a_probe_that_comes_down_more_steeply_than_the_device_explains) {
  Falls falls(Method::pdg);
  Falls::Tick tick = down(2e-3, 2e-3 - 1e-6, 1e-5);
  EXPECT_FALSE(falls.released(tick));
  tick.fallen = 1e-9;
  EXPECT_EQ(falls.released(tick), tick.let_go);
}

// A ledge of 1 mm, of which each tick sees 10 um: less than the device moves meanwhile.
TEST(Falls, a_fall_that_lags_behind_the_device_says_all_that_it_lets_go) {
  Falls falls(Method::pdg);
  double depth = 3e-3, said = 0;
  for (int i = 0; i < 100; ++i) {
    const double lower = depth - 1e-5;
    said += falls.released(down(depth, lower, 5e-5, i == 99)).value_or(0);
    depth = lower;
  }
  EXPECT_NEAR(said, 9e-6 - 4e-6, 1e-3 * 9e-6);
  // It has caught up: what holds it now lets nothing go.
  EXPECT_FALSE(falls.released(down(depth, depth - 1e-8, 5e-5)));
}

TEST(Falls, what_the_gap_at_the_contacts_amounts_to_is_no_fall) {
  Falls falls(Method::pdg);
  EXPECT_FALSE(falls.released(down(2e-3, 2e-3 - 1e-9, 1e-5, false)));
  // But many such ticks are.
  bool said = false;
  for (int i = 0; i < 100; ++i)
    said |= falls.released(down(2e-3, 2e-3 - 1e-9, 1e-5, false)).has_value();
  EXPECT_TRUE(said);
}

TEST(Falls, the_slope_of_what_is_held_grows_with_what_the_device_has_moved_unanswered) {
  Falls falls(Method::pdg);
  const double one = falls.held_slope(1e-5);
  EXPECT_GE(one, 1e-5);
  falls.released(against_a_wall(2e-3, 1e-5, false));
  EXPECT_NEAR(falls.held_slope(1e-5), 2 * one, 1e-12);
  falls.released(against_a_wall(2e-3, 1e-5));
  EXPECT_EQ(falls.held_slope(1e-5), one);
  falls.released(against_a_wall(2e-3, 1e-5, false));
  falls.forget();
  EXPECT_EQ(falls.held_slope(1e-5), one);
}

TEST(Falls, a_probe_that_comes_into_contact_has_let_nothing_go) {
  Falls falls(Method::pdg);
  EXPECT_FALSE(falls.released({.moved = 1e-3,
                               .way = 1e-3,
                               .before = 0,
                               .depth = 5e-4,
                               .clearance = clearance,
                               .let_go = 1e-9,
                               .converged = false}));
}

}  // namespace
}  // namespace sonde
