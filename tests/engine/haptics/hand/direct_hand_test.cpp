// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/direct_hand.hpp"

#include <gtest/gtest.h>

#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

TEST(DirectHand, the_probe_is_where_the_newest_target_is) {
  DirectHand direct({Quat::Identity(), Vec3(1, 2, 3)});
  const Hand hand = direct.hand();
  EXPECT_EQ(hand.sample(0).X_FM.p, Vec3(1, 2, 3));
  direct.set_target({Quat::Identity(), Vec3(4, 5, 6)});
  direct.set_target({Quat::Identity(), Vec3(7, 8, 9)});
  test::AllocationCounter counter;
  const HandSample sample = hand.sample(0.001);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0U);
  EXPECT_EQ(sample.X_FM.p, Vec3(7, 8, 9));
  EXPECT_TRUE(sample.held && sample.trusted);
}

}  // namespace
}  // namespace sonde
