// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/lessened.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/haptics/safety/force_gate.hpp"

namespace sonde {
namespace {

constexpr double tick = 1e-3;

class LessenedTest : public testing::Test {
 protected:
  /// A tick of the gate, which is the reference for what acts.
  Lessened pass(const Wrench& asked, Withheld why = Withheld::nothing) {
    const Wrench within = limit(asked, coupling.max_force, coupling.max_torque);
    given = gate.pass(within, why, coupling.max_force, coupling.max_torque, tick);
    hand.asked = within;
    hand.withheld = gate.withheld();
    hand.share = gate.share();
    hand.slewed = gate.slewed();
    return force_lessened(given, hand, coupling);
  }
  static Wrench pull(double newton) { return {.force = {newton, 0, 0}}; }

  Coupling coupling;  // 10 N at most
  SafetySettings safety;
  ForceGate gate{safety};
  HandState hand;
  Wrench given;
};

/// 50 N are asked for, so the coupling's limit acts on what is asked; but what the hand gets is
/// 0.03 N because the force has just begun to come in.
TEST_F(LessenedTest, a_force_that_comes_in_is_not_at_its_limit) {
  EXPECT_EQ(pass(pull(50)), Lessened::coming_in);
  EXPECT_LT(given.force.norm(), 0.05);
  EXPECT_TRUE(hand.asked.saturated);
  for (int i = 0; i < 400; ++i) pass(pull(50));
  EXPECT_EQ(pass(pull(50)), Lessened::limited);
  EXPECT_NEAR(given.force.norm(), 10, 1e-9);
  EXPECT_EQ(torque_lessened(given, hand, coupling), Lessened::nothing) << "no torque is asked for";
}

/// A recording keeps forces in 32 bits, whose length may come out a little below the limit.
TEST(Lessened, a_recorded_force_at_its_limit_is_limited) {
  Coupling coupling;
  coupling.max_force = 10;
  HandState hand;
  hand.share = 1;
  Wrench recorded;
  for (int i = 1; i < 200; ++i) {
    const Vec3 at_limit = Vec3(std::sin(i), std::cos(3 * i), 0.1 * i).normalized() * 10;
    recorded.force = at_limit.cast<float>().cast<double>();
    hand.asked = recorded;
    EXPECT_EQ(force_lessened(recorded, hand, coupling), Lessened::limited) << i;
  }
}

TEST_F(LessenedTest, a_whole_force_below_its_limit_is_lessened_by_nothing) {
  for (int i = 0; i < 400; ++i) pass(pull(3));
  EXPECT_EQ(pass(pull(3)), Lessened::nothing);
  EXPECT_EQ(pass(pull(9)), Lessened::slewed) << "6 N in a tick are more than 5 kN/s";
  EXPECT_EQ(pass(pull(9), Withheld::unsettled), Lessened::fading);
  EXPECT_EQ(pass(pull(9), Withheld::stopped), Lessened::nothing) << "there is none";
}

}  // namespace
}  // namespace sonde
