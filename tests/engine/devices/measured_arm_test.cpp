// SPDX-License-Identifier: GPL-3.0-or-later
// Pulses to an arm, from the plan to the maker's library: the reference is the force that the
// stand-in was told.
#include <gtest/gtest.h>

#include <optional>

#include "engine/haptics/loop/servo.hpp"
#include "engine/study/identification/measured_hand.hpp"
#include "tests/engine/devices/makers.hpp"
#include "tests/engine/devices/over_hid.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

struct MeasuredArm : testing::TestWithParam<Maker> {
  const Maker& maker = GetParam();
  MockSystem system;  ///< no HID device of the machine takes part
  LoadedStandin standin{maker.library};
  const Pose in_contact{Quat::Identity(), Vec3(0, 0, 0.073)};  ///< 2 mm: it would push
  PulsePlan plan;
  std::shared_ptr<InputDevice> device;
  std::optional<MeasuredHand> hand;
  std::optional<Servo> servo;

  MeasuredArm() {
    forget_makers();
    ::setenv(maker.variable, maker.library, 1);
  }
  ~MeasuredArm() override {
    end();
    forget_makers();
  }
  void end() {
    servo.reset();
    hand.reset();
    device.reset();
  }

  void begin() {
    device = std::make_shared<InputDevice>(DeviceChoice{.path = maker.path});
    ASSERT_TRUE(reaches(*device, DeviceState::ready)) << device->status().reason;
    DeviceProfile profile;
    profile.max_force.value = 3;
    profile.mass.value = 0.1;
    plan = plan_pulses(profile, {}, 1e-3);
    hand.emplace(device, plan, bounds_of(plan, {}), in_contact);
    ServoSettings settings;
    servo.emplace(Pair{body(box({0.02, 0.03, 0.05})), body(box({0.3, 0.3, 0.1}))}, Method::pdg,
                  Coupling{}, settings);
    servo->start(in_contact, hand->hand());
  }
  Vec3 force() const { return maker.force(standin); }
  PulseProgress progress() { return hand->pulses().progress(); }
  /// Follows the force while it lasts; the largest.
  double until(std::size_t pulse) {
    double most = 0;
    EXPECT_TRUE(comes_true([&] {
      const Vec3 now = force();
      EXPECT_EQ(now.tail<2>().norm(), 0) << "the first pulses are along x";
      most = std::max(most, now.norm());
      return progress().pulse >= pulse || progress().end != PulsesEnd::none;
    }));
    return most;
  }
  /// Begins, and plays so many pulses; the largest force. A machine that does much else may hold up
  /// the thread that reads the arm: an arm that is not heard of is lost, rightly, and it begins
  /// anew.
  double played(std::size_t pulse) {
    for (int attempt = 0; attempt < 5 && !HasFatalFailure(); ++attempt) {
      begin();
      if (HasFatalFailure()) break;
      const double most = until(pulse);
      if (progress().end != PulsesEnd::lost) return most;
      end();
    }
    ADD_FAILURE() << "it was not heard of in any of five runs";
    return 0;
  }
  void expect_over(PulsesEnd why) {
    ASSERT_TRUE(comes_true([&] { return progress().end != PulsesEnd::none; }));
    EXPECT_EQ(progress().end, why) << words(progress().end);
    EXPECT_TRUE(comes_true([&] { return force().isZero(0) || !standin->force_on; }));
  }
};

TEST_P(MeasuredArm, its_motors_get_the_pulses_and_no_contact) {
  const double most = played(8);
  ASSERT_TRUE(hand);
  EXPECT_EQ(progress().end, PulsesEnd::none) << words(progress().end);
  EXPECT_GT(most, 0.4 * 1.5);
  EXPECT_LE(most, 1.5 + 1e-9) << "half of 3 N";
  servo->set_force(false);
  expect_over(PulsesEnd::withheld);
  EXPECT_EQ(progress().withheld, Withheld::stopped);
}

TEST_P(MeasuredArm, one_that_is_unplugged_ends_it) {
  begin();
  until(2);
  standin->unplugged = true;
  expect_over(PulsesEnd::lost);
}

TEST_P(MeasuredArm, a_hand_that_takes_the_handle_away_ends_it) {
  for (int attempt = 0; attempt < 5; ++attempt) {  // one that is lost, as in played()
    standin.move_to(maker.place(Vec3::Zero()));
    played(2);
    ASSERT_TRUE(hand);
    for (int i = 0; i < 2000 && progress().end == PulsesEnd::none; ++i) {
      standin.move_to(maker.place(Vec3(0, 5e-5 * i, 0)));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (progress().end != PulsesEnd::lost) break;
    end();
  }
  ASSERT_TRUE(hand) << "it was not heard of in any of five runs";
  EXPECT_TRUE(progress().end == PulsesEnd::restless || progress().end == PulsesEnd::drifted)
      << words(progress().end);
  expect_over(progress().end);
}

INSTANTIATE_TEST_SUITE_P(Makers, MeasuredArm, testing::Values(force_dimension, three_d),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace sonde::test
