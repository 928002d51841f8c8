// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/clearance_gauge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using namespace std::chrono_literals;

class ClearanceTest : public testing::Test {
 protected:
  Pair pair{test::body(test::box({0.02, 0.03, 0.05})), test::body(test::box({0.3, 0.3, 0.1}))};
  ClearanceGauge gauge{pair};
};

/// Closed form: a box of half its height 25 mm over a block of half its height 50 mm.
TEST_F(ClearanceTest, of_a_box_above_a_block_is_the_gap_between_their_faces) {
  for (const double gap : {0.01, 1e-3, 1e-6}) {
    const Pose at{Quat::Identity(), {0.01, 0.02, 0.075 + gap}};
    const auto found = gauge.at(at, 10s);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->device.p, at.p);
    EXPECT_NEAR(found->distance, gap, 1e-15);
    EXPECT_NEAR((found->on_probe - found->on_fixed).norm(), gap, 1e-15);
    EXPECT_NEAR(found->on_fixed.z(), 0.05, 1e-15);
    EXPECT_NEAR(found->on_probe.z(), 0.05 + gap, 1e-15);
  }
}

/// Closed form: turned by 45° about y, its lowest edge is (w + h)/√8 below its centre.
TEST_F(ClearanceTest, of_a_turned_box_is_that_of_its_lowest_edge) {
  const double below = (0.02 + 0.05) / std::sqrt(8.0);
  const Quat turn(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()));
  const auto found = gauge.at({turn, {0, 0, 0.05 + below + 0.004}}, 10s);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->distance, 0.004, 1e-14);
}

TEST_F(ClearanceTest, of_bodies_that_overlap_is_none_also_where_one_is_inside_the_other) {
  for (const double z : {0.07, 0.0}) {
    const auto found = gauge.at({Quat::Identity(), {0, 0, z}}, 10s);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->distance, 0) << z;
  }
}

TEST_F(ClearanceTest, with_no_patience_gives_what_there_is_and_that_pose_follows) {
  const Pose first{Quat::Identity(), {0, 0, 0.08}}, second{Quat::Identity(), {0, 0, 0.09}};
  ASSERT_TRUE(gauge.at(first, 10s));
  const auto soon = gauge.at(second, 0us);
  ASSERT_TRUE(soon);
  const auto then = gauge.at(second, 10s);
  EXPECT_EQ(then->device.p, second.p);
}

TEST(SignedClearance, is_the_room_or_minus_the_depth) {
  Separation s;
  s.depth = 0.002;
  GaugedClearance room;
  room.distance = 0.003;
  s.status = Status::penetrating;
  EXPECT_EQ(signed_clearance(s, &room), -0.002);
  s.depth = 0;
  EXPECT_FALSE(std::signbit(signed_clearance(s, &room).value())) << "touching is no -0";
  s.status = Status::separated;
  EXPECT_EQ(signed_clearance(s, &room), 0.003);
  EXPECT_EQ(signed_clearance(s, nullptr), std::nullopt);
  s.status = Status::failed;
  EXPECT_EQ(signed_clearance(s, &room), std::nullopt);
}

}  // namespace
}  // namespace sonde
