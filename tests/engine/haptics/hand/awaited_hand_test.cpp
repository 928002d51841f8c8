// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/hand/awaited_hand.hpp"

#include <gtest/gtest.h>

#include "tests/support/allocation_counter.hpp"

namespace sonde {
namespace {

struct Asked {
  int samples = 0, renders = 0, follows = 0;
  double dt = -1;
  Hand hand() {
    return {.sample =
                [this](double time) {
                  ++samples;
                  dt = time;
                  return HandSample{.X_FM = {Quat::Identity(), Vec3(1, 0, 0)}};
                },
            .render = [this](const Wrench&) { ++renders; },
            .follow = [this](double) { ++follows; }};
  }
};

TEST(AwaitedHand, it_is_not_asked_before_every_loop_has_ended) {
  Asked asked;
  const auto one = std::make_shared<std::atomic<bool>>(false);
  const auto other = std::make_shared<std::atomic<bool>>(false);
  const Hand hand = awaited(asked.hand(), {one, other}, {Quat::Identity(), Vec3(0, 2, 0)});
  const auto tick = [&] {
    const HandSample sample = hand.sample(0.001);
    hand.render({});
    hand.follow(1);
    return sample;
  };
  for (int i = 0; i < 3; ++i) {
    const HandSample waits = tick();
    EXPECT_EQ(waits.X_FM.p, Vec3(0, 2, 0)) << "the probe stays";
    EXPECT_TRUE(waits.changed) << "and has no force";
    EXPECT_FALSE(waits.device);
    if (i == 1) *one = true;
  }
  EXPECT_EQ(asked.samples + asked.renders + asked.follows, 0);
  *other = true;
  const HandSample first = tick();
  EXPECT_EQ(first.X_FM.p, Vec3(1, 0, 0));
  EXPECT_TRUE(first.changed);
  EXPECT_EQ(asked.dt, 0) << "its first";
  EXPECT_FALSE(tick().changed);
  EXPECT_EQ(asked.dt, 0.001);
  EXPECT_EQ(asked.samples, 2);
  EXPECT_EQ(asked.renders, 2);
  EXPECT_EQ(asked.follows, 2);
}

TEST(AwaitedHand, where_nothing_is_to_be_awaited_it_is_the_hand_itself) {
  Asked asked;
  const auto ended = std::make_shared<std::atomic<bool>>(true);
  EXPECT_FALSE(awaited(asked.hand(), {ended}, {}).sample(0.001).changed);
  EXPECT_FALSE(awaited(asked.hand(), {}, {}).sample(0.001).changed);
}

TEST(AwaitedHand, it_neither_allocates_nor_frees) {
  Asked asked;
  const auto ended = std::make_shared<std::atomic<bool>>(false);
  const Hand hand = awaited(asked.hand(), {ended}, {});
  test::AllocationCounter counter;
  for (int i = 0; i < 10; ++i) {
    if (i == 5) *ended = true;
    hand.sample(0.001);
    hand.render({});
  }
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0U);
}

}  // namespace
}  // namespace sonde
