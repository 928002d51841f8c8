// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is a linear map whose fixed point is known: the wanted step at y is M (x − y).
#include "engine/penetration/descent/step_mixing.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

Vec6 fixed_point() {
  Vec6 x;
  x << 1, -2, 0.5, 3, 0.1, -1;
  return x;
}

/// Two modes: one of which each step covers a twentieth, and one that each step passes by.
Vec6 wanted(const Vec6& y) {
  Vec6 share = Vec6::Ones();
  share[0] = 0.05, share[3] = 1.7;
  return share.cwiseProduct(fixed_point() - y);
}

Vec6 off_by(double slow, double swinging) {
  Vec6 y = fixed_point();
  y[0] -= slow, y[3] -= swinging;
  return y;
}

TEST(StepMixing, three_poses_tell_where_two_modes_end) {
  StepMixing mixing;
  Vec6 y = off_by(0.3, 0.2);
  for (int pose = 0; pose < 3; ++pose) {
    EXPECT_FALSE(mixing.mixed());
    mixing.note(y, wanted(y));
    if (pose < 2) y += wanted(y);
  }
  ASSERT_TRUE(mixing.mixed());
  // Plain steps would still be 90 % off in one of them.
  EXPECT_NEAR((y + *mixing.mixed() - fixed_point()).norm(), 0, 1e-3);
}

TEST(StepMixing, poses_need_not_follow_the_wanted_steps) {
  StepMixing mixing;
  for (const Vec6& y : {off_by(0.3, 0.2), off_by(0.25, 0.3), off_by(0.1, -0.1)})
    mixing.note(y, wanted(y));
  ASSERT_TRUE(mixing.mixed());
  EXPECT_NEAR((off_by(0.1, -0.1) + *mixing.mixed() - fixed_point()).norm(), 0, 1e-3);
}

TEST(StepMixing, changes_in_one_direction_only_give_a_step_in_that_direction) {
  StepMixing mixing;
  for (const double off : {0.4, 0.38, 0.361}) mixing.note(off_by(off, 0), wanted(off_by(off, 0)));
  ASSERT_TRUE(mixing.mixed());
  EXPECT_NEAR((off_by(0.361, 0) + *mixing.mixed() - fixed_point()).norm(), 0, 1e-3);
}

TEST(StepMixing, poses_that_do_not_change_give_none) {
  StepMixing mixing;
  for (int i = 0; i < 5; ++i) mixing.note(off_by(0.4, 0.1), wanted(off_by(0.4, 0.1)));
  EXPECT_FALSE(mixing.mixed());
}

TEST(StepMixing, after_a_mixed_step_that_led_to_longer_ones_it_waits_longer_each_time) {
  StepMixing mixing;
  int last = 0;
  for (int times = 0; times < 3; ++times) {
    int waited = 0;
    Vec6 y = off_by(0.3, 0.2);
    for (; !mixing.mixed(); ++waited)
      mixing.note(y, wanted(y)), y[0] += 0.01 * waited, y[3] -= 0.02;
    EXPECT_GT(waited, last);
    last = waited;
    mixing.take();
    const Vec6 away = off_by(9 + times, 9 + times);
    mixing.note(away, wanted(away));
    EXPECT_FALSE(mixing.mixed());
  }
}

// By poses at which the wanted step is another function: of those before it would be a wrong one.
TEST(StepMixing, after_such_a_step_nothing_of_the_poses_before_it_is_used) {
  const auto anew = [](const Vec6& y) { return Vec6(0.5 * (fixed_point() - y)); };
  StepMixing mixing;
  for (const Vec6& y : {off_by(0.3, 0.2), off_by(0.25, 0.3), off_by(0.1, -0.1)})
    mixing.note(y, wanted(y));
  mixing.take();
  mixing.note(off_by(9, 9), anew(off_by(9, 9)));
  Vec6 y = off_by(8, 9);
  for (int pose = 0; pose < 4; ++pose, y = off_by(7 - pose, 5 + 2 * (pose % 2))) {
    mixing.note(y, anew(y));
    if (const std::optional<Vec6> step = mixing.mixed()) {
      EXPECT_GE(pose, 1);
      EXPECT_NEAR((y + *step - fixed_point()).norm(), 0, 1e-6);
    }
  }
  EXPECT_TRUE(mixing.mixed());
}

TEST(StepMixing, a_map_that_overflows_gives_none) {
  StepMixing mixing;
  for (const double size : {1e-200, 2e-200, 4e-200}) {  // squares of these are 0
    const Vec6 y = size * Vec6::Ones();
    mixing.note(y, y);
  }
  EXPECT_FALSE(mixing.mixed());
  for (const double size : {1e200, 3e200, 2e200}) {  // and of these, infinite
    const Vec6 y = size * fixed_point();
    mixing.note(y, -0.5 * y.cwiseAbs());
  }
  EXPECT_FALSE(mixing.mixed());
}

TEST(StepMixing, after_one_that_led_to_shorter_steps_it_goes_on) {
  StepMixing mixing;
  for (const Vec6& y : {off_by(0.3, 0.2), off_by(0.25, 0.3), off_by(0.1, -0.1)})
    mixing.note(y, wanted(y));
  mixing.take();
  mixing.note(off_by(0.01, 0.02), wanted(off_by(0.01, 0.02)));
  EXPECT_TRUE(mixing.mixed());
}

}  // namespace
}  // namespace sonde
