// SPDX-License-Identifier: GPL-3.0-or-later
// References: k times the way, by hand, for a spring of 200 N/m.
#include "engine/haptics/safety/hand_way.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

struct HandWayTest : testing::Test {
  static constexpr double dt = 1e-3, k = 200;
  static constexpr HandWay::Most most{2, 1};
  static constexpr ChangeRate rate{10, 0.1};
  MassProperties mass;
  Coupling coupling;
  HandWay way;
  Pose at;
  HandWayTest() {
    mass.inertia = Vec3::Constant(1e-4);
    mass.radius = 0.02;
    coupling.k = k;
  }

  void move(const Vec3& by, const Vec3& force = Vec3::Zero(), double since = dt) {
    Pose next = at;
    next.p += by;
    way.measure(mass, {at, next, force, 2, since, dt});
    at = next;
  }
  ForceGate::Slew slew(bool separated = false) {
    return way.slew(mass, coupling, most, rate, separated, dt);
  }
};

TEST_F(HandWayTest, permits_twice_what_the_way_makes_of_the_spring) {
  move({0, 0, -1e-4});
  EXPECT_NEAR(slew().force, 2 * k * 1e-4 / dt + rate.force, 1e-9);
  // A turn of one axis: kÎθ, through y = 2√Î sin(θ/2).
  const double turn = 2e-4;
  Pose next = at;
  next.q = Quat(Eigen::AngleAxisd(turn, Vec3::UnitX())) * at.q;
  way.measure(mass, {at, next, Vec3::Zero(), 2, dt, dt});
  EXPECT_NEAR(slew().torque, 2 * k * 1e-4 * turn / dt + rate.torque, 1e-8);
}

TEST_F(HandWayTest, is_no_more_than_all_of_the_force_in_ten_milliseconds) {
  move({0, 0, -1.5e-3});
  EXPECT_NEAR(slew().force, most.force / 0.01 + rate.force, 1e-9);
}

TEST_F(HandWayTest, what_the_force_moved_permits_no_rise_but_a_fall) {
  move({3e-5, 0, 4e-5}, {0, 0, 2});
  EXPECT_NEAR(way.yields(), 4e-5 / dt, 1e-12);
  EXPECT_NEAR(slew().force, 2 * k * 3e-5 / dt + rate.force, 1e-9);
  EXPECT_NEAR(slew().falling_force, 2 * k * 5e-5 / dt, 1e-9);
}

TEST_F(HandWayTest, a_leap_permits_nothing_and_ends_nothing) {
  move({0, 0, -1e-3});
  EXPECT_TRUE(slew(true).ends_at_once);
  move({0, 0, -0.003});  // 3 m/s; 2 are possible
  EXPECT_TRUE(way.leapt());
  EXPECT_EQ(slew().force, rate.force);
  EXPECT_FALSE(slew(true).ends_at_once);
  way.restart();
  EXPECT_FALSE(way.leapt());
}

// A report each fifth tick, of 0.5 mm: 200 N/m make 0.2 N of it, twice; a tick may take a part.
TEST_F(HandWayTest, a_report_counts_until_the_next_is_due) {
  const Vec3 by(0, 0, -5e-4);
  move(by, Vec3::Zero(), 5 * dt);
  EXPECT_NEAR(way.velocity().z(), -0.1, 1e-12);
  slew();
  way.spend({.force = {0, 0, 0.05}, .torque = Vec3::Zero()}, dt);
  move(Vec3::Zero());
  EXPECT_NEAR(way.velocity().z(), -0.1, 1e-12) << "it goes on";
  EXPECT_NEAR(slew().force, (2 * k * 5e-4 - 0.05) / dt + rate.force, 1e-9);
  for (int i = 0; i < 4; ++i) {
    way.spend({.force = {0, 0, 0.05}, .torque = Vec3::Zero()}, dt);
    move(Vec3::Zero());
    slew();
  }
  EXPECT_EQ(slew().force, rate.force) << "the next was due";
  EXPECT_EQ(way.velocity().z(), 0);
}

TEST_F(HandWayTest, where_no_rate_is_limited_nothing_is) {
  move({0, 0, -1e-4});
  const ForceGate::Slew none = way.slew(mass, coupling, most, {.force = 0, .torque = 0}, false, dt);
  EXPECT_EQ(none.force, 0) << "none";
  EXPECT_TRUE(none.ends_at_once);
}

}  // namespace
}  // namespace sonde
