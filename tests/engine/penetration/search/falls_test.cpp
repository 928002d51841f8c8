// SPDX-License-Identifier: GPL-3.0-or-later
// The reference of each test is the geometry that it describes: a wall, a slope or a ledge, for
// which depth and energy are known in closed form.
#include "engine/penetration/search/falls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

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

void expect_fall(const std::optional<Falls::Release>& said, double let_go) {
  ASSERT_TRUE(said);
  EXPECT_EQ(said->energy, let_go);
  EXPECT_FALSE(said->lagged);
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
    expect_fall(falls.released(tick), tick.let_go);
  }
}

TEST(Falls, so_has_a_probe_that_comes_down_more_steeply_than_the_device_explains) {
  Falls falls(Method::pdg);
  Falls::Tick tick = down(2e-3, 2e-3 - 1e-6, 1e-5);
  EXPECT_FALSE(falls.released(tick));
  tick.fallen = 1e-9;
  expect_fall(falls.released(tick), tick.let_go);
}

// Its energy is that of the forces at its two ends, so contacts that come or go in between seem to
// let go up to a tenth of what the two motions amount to.
TEST(Falls, what_may_be_due_to_contacts_that_change_in_a_tick_is_no_fall) {
  for (const double share : {0.09, 0.11}) {
    Falls falls(Method::pdg);
    Falls::Tick tick = down(2e-3, 1e-3, 1e-4);
    tick.let_go = share * tick.moved * tick.way;
    EXPECT_EQ(falls.released(tick).has_value(), share > 0.1);
  }
}

// A ledge of 1 mm, of which each tick sees 10 um: less than the device moves meanwhile.
TEST(Falls, a_fall_that_lags_behind_the_device_says_all_that_it_lets_go) {
  Falls falls(Method::pdg);
  double depth = 3e-3, said = 0;
  for (int i = 0; i < 100; ++i) {
    const double lower = depth - 1e-5;
    if (const auto release = falls.released(down(depth, lower, 5e-5, i == 99))) {
      EXPECT_TRUE(release->lagged);
      said += release->energy;
    }
    depth = lower;
  }
  EXPECT_NEAR(said, 9e-6 - 4e-6, 1e-3 * 9e-6);
  // It has caught up: what holds it now lets nothing go.
  EXPECT_FALSE(falls.released(down(depth, depth - 1e-8, 5e-5)));
}

// A probe at its contacts may be two gaps above them. By a quarter of that, at a depth of 2 mm, it
// may go down unsaid.
constexpr double gaps = 2 * Descent::gap_of_follower * clearance;
double unsaid_at(double depth) { return 0.25 * 2 * gaps * depth; }

/// Comes down from 2 mm by steps that each let `share` of that go; returns the number of the first
/// that says so, and what it says.
std::pair<int, double> first_said(Falls& falls, double share) {
  double depth = 2e-3;
  for (int i = 1; i < 1000; ++i) {
    const double lower = std::sqrt(depth * depth - share * unsaid_at(2e-3));
    if (const auto said = falls.released(down(depth, lower, 1e-5, false))) return {i, said->energy};
    depth = lower;
  }
  return {};
}

/// After a tick that converged.
Falls behind() {
  Falls falls(Method::pdg);
  falls.released(against_a_wall(2e-3, 0));
  return falls;
}

TEST(Falls, what_a_probe_that_is_behind_lets_go_unsaid_adds_up_and_is_said_with_the_rest) {
  for (const double share : {0.011, 0.11, 0.3, 0.7, 1.1}) {
    Falls falls = behind();
    const int expected = static_cast<int>(std::ceil(1 / share));
    for (int again = 0; again < 3; ++again) {  // once said, it adds up from nothing
      const auto [ticks, energy] = first_said(falls, share);
      EXPECT_EQ(ticks, expected) << share;
      EXPECT_NEAR(energy, expected * share * unsaid_at(2e-3), 1e-3 * unsaid_at(2e-3)) << share;
    }
  }
}

TEST(Falls, a_tick_that_converges_after_one_that_did_clears_what_was_not_said) {
  Falls falls = behind();
  const Falls::Tick some = down(2e-3, std::sqrt(4e-6 - 0.7 * unsaid_at(2e-3)), 1e-5, false);
  EXPECT_FALSE(falls.released(some));
  falls.released(against_a_wall(2e-3, 0));  // catches up
  falls.released(against_a_wall(2e-3, 0));
  EXPECT_FALSE(falls.released(some));
  EXPECT_TRUE(falls.released(some));
}

// What the force seems to give in one tick and to take in the next is no store of energy: a probe
// that is behind and stays where it is, is pushed deeper and comes back.
TEST(Falls, what_seems_to_come_from_nothing_pays_for_no_later_loss) {
  Falls falls = behind();
  Falls::Tick gains = against_a_wall(2e-3, 1e-5, false);
  gains.let_go = -100 * unsaid_at(2e-3);
  EXPECT_FALSE(falls.released(gains));
  EXPECT_EQ(first_said(falls, 0.7).first, 2);
}

TEST(Falls, a_probe_that_may_not_turn_says_falls_only) {
  Falls falls(Method::pdt);
  falls.released(against_a_wall(2e-3, 0));
  EXPECT_EQ(first_said(falls, 0.7).first, 0);
}

// The first tick after a search comes down through all of the clearance that a search leaves.
TEST(Falls, after_a_search_all_of_the_clearance_is_its_gap) {
  Falls falls(Method::pdg);
  const double share = 1 / (2 * Descent::gap_of_follower);
  EXPECT_EQ(first_said(falls, 0.7 * share).first, 2);
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
