// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/path_hand.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

Pose at_x(double x, double angle = 0) {
  return {Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())), Vec3(x, 0, 0)};
}
const std::vector<TimedPose> path{{10, at_x(1)}, {10.5, at_x(2, 0.4)}, {12, at_x(5, 0.4)}};

TEST(PathHand, a_pose_between_two_lies_on_the_way_from_one_to_the_other) {
  EXPECT_EQ(pose_at(path, 0).p.x(), 1);
  EXPECT_NEAR(pose_at(path, 10.25).p.x(), 1.5, 1e-15);
  EXPECT_NEAR(pose_at(path, 10.25).q.angularDistance(at_x(0).q), 0.2, 1e-12);
  EXPECT_NEAR(pose_at(path, 11).p.x(), 3, 1e-15);
  EXPECT_EQ(pose_at(path, 12).p.x(), 5);
  EXPECT_EQ(pose_at(path, 99).p.x(), 5);
}

TEST(PathHand, it_comes_to_the_path_follows_it_in_its_own_time_and_stays) {
  PathHand replay(path, at_x(0));
  const Hand hand = replay.hand();
  EXPECT_EQ(hand.sample(0).X_FM.p.x(), 0) << "from where the probe is";
  EXPECT_NEAR(hand.sample(0.5).X_FM.p.x(), 0.5, 1e-12);
  EXPECT_NEAR(hand.sample(0.5).X_FM.p.x(), 1, 1e-12);
  EXPECT_NEAR(hand.sample(1).X_FM.p.x(), 3, 1e-12);
  EXPECT_EQ(hand.sample(7).X_FM.p.x(), 5);
  test::AllocationCounter counter;
  const HandSample last = hand.sample(7);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0U);
  EXPECT_EQ(last.X_FM.p.x(), 5);
  EXPECT_TRUE(last.held && last.trusted);
  EXPECT_FALSE(hand.render);
}

TEST(PathHand, a_path_without_poses_is_refused) {
  EXPECT_THROW(PathHand({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace sonde
