// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps the hand safe, from the maker's library to the maker's library: the reference is the
// force that the stand-in was told.
#include <gtest/gtest.h>

#include <optional>

#include "tests/engine/devices/makers.hpp"
#include "tests/engine/devices/pressed_block.hpp"

namespace sonde::test {
namespace {

struct ArmSafety : testing::TestWithParam<Maker> {
  const Maker& maker = GetParam();
  MockSystem system;  ///< no HID device of the machine takes part
  LoadedStandin standin{maker.library};
  std::optional<PressedBlock> loop;

  ArmSafety() {
    forget_makers();
    ::setenv(maker.variable, maker.library, 1);
  }
  ~ArmSafety() override {
    loop.reset();
    forget_makers();
  }

  void begin(const ServoSettings& settings = PressedBlock::settings()) {
    move(Vec3::Zero());
    loop.emplace(DeviceChoice{.path = maker.path}, settings);
    ASSERT_TRUE(comes_true([&] { return trusted(); })) << loop->device->status().reason;
  }
  bool trusted() { return loop->now().tick > 0 && loop->withheld() == Withheld::nothing; }
  void move(const Vec3& p) { standin.move_to(maker.place(p)); }
  /// Its handle 3 mm down: the probe is 2 mm deep.
  void press() { move(Vec3(0, 0, -0.003)); }
  Vec3 force() const { return maker.force(standin); }
  /// The stiffness is 500 N/m by default.
  bool pushed_back() { return std::abs(force().z() - 1) < 0.02; }
  void press_in() {
    press();
    ASSERT_TRUE(comes_true([&] { return pushed_back(); })) << force().transpose();
  }
  bool let_go(Withheld why) { return loop->withheld() == why && force().isZero(0); }

  /// One reading of the handle after another: `place` for each, until `seen`.
  template <class Place, class Seen>
  bool on_and_on(const Place& place, const Seen& seen) {
    int readings = standin->frames;
    for (int i = 0; i < 20000 && !seen(); ++i) {
      place(i);
      if (!comes_true([&] { return standin->frames > readings; })) return false;
      readings = standin->frames;
    }
    return seen();
  }
};

TEST_P(ArmSafety, the_force_of_a_contact_rises_from_zero_and_no_faster_than_its_limit) {
  ServoSettings settings = PressedBlock::settings();
  settings.safety.ramp_time = 0.2;
  settings.safety.force_slew = 20;  // N/s: a force of 1 N takes 50 ms
  begin(settings);
  Snapshot tick, last;
  while (loop->servo.next_tick(last)) continue;
  press_in();
  // The reference is the limit itself over each tick's own time: a machine that does much else
  // makes ticks late, and one that is later than 5 ms counts for 5 ms.
  double pushed = 0;
  int rising = 0;
  while (loop->servo.next_tick(tick)) {
    const double since = tick.time - last.time;
    const double more = tick.wrench.force.norm() - last.wrench.force.norm();
    const double counted = 0.005 * static_cast<double>(tick.tick - last.tick);
    EXPECT_LE(more, 20 * std::min(since, counted) + 1e-6) << "after " << since << " s";
    if (more > 0) ++rising;
    pushed = std::max(pushed, tick.wrench.force.norm());
    last = tick;
  }
  EXPECT_NEAR(pushed, 1, 0.02);
  EXPECT_GE(rising, 9) << "1 N in steps of at most 0.1 N";
}

// Reference: K (T/2 + t_d) = b + 1 N·s/m, by its profile; without one, of what is then assumed.
TEST_P(ArmSafety, gains_that_would_be_unstable_wait_until_the_contact_is_left) {
  DeviceTraits handle;
  handle.damping = 0.5;
  handle.delay = 1e-3;
  handle.mass = 0.3;
  for (const bool profiled : {true, false}) {
    begin();
    if (profiled) loop->hand.set_profile(handle);
    press_in();
    Coupling stiff;
    stiff.k = 50'000;
    loop->servo.set_coupling(stiff);
    ASSERT_TRUE(comes_true([&] { return loop->now().hand.waiting; })) << profiled;
    const double expected = profiled ? 1.5 / 1.5e-3 : 1.2 / 1.5e-3;
    const double k = loop->now().hand.gains.now.k;
    // Those of rotations, 1.2 k Î, may be stiffer on this probe: 2157 N/m without a profile.
    EXPECT_NEAR(k, expected, 0.01 * expected) << profiled;
    EXPECT_TRUE(comes_true([&] { return std::abs(force().z() - 0.002 * k) < 0.02; }))
        << "a wall that is felt meanwhile: " << force().transpose() << " N at " << k << " N/m";
    move(Vec3(0, 0, 0.01));
    ASSERT_TRUE(comes_true([&] { return loop->now().hand.gains.now.k == 50'000; })) << profiled;
    EXPECT_FALSE(loop->now().hand.waiting);
    loop.reset();
  }
}

TEST_P(ArmSafety, escape_ends_the_force_and_after_it_the_force_rises_again) {
  begin();
  press_in();
  loop->servo.set_force(false);
  ASSERT_TRUE(comes_true([&] { return let_go(Withheld::stopped); }));
  Snapshot tick;
  while (loop->servo.next_tick(tick)) EXPECT_TRUE(tick.hand.share <= 1);
  loop->servo.set_force(true);
  ASSERT_TRUE(comes_true([&] { return pushed_back(); }));
  double first = 0;
  while (first == 0 && loop->servo.next_tick(tick)) first = tick.wrench.force.norm();
  EXPECT_GT(first, 0);
  EXPECT_LT(first, 0.9);
}

TEST_P(ArmSafety, a_pause_and_the_end_of_the_loop_leave_no_force) {
  begin();
  press_in();
  loop->servo.set_paused(true);
  ASSERT_TRUE(comes_true([&] { return let_go(Withheld::paused); }));
  loop->servo.set_paused(false);
  ASSERT_TRUE(comes_true([&] { return pushed_back(); }));
  loop->servo.stop();
  ASSERT_TRUE(comes_true([&] { return force().isZero(0); }));
}

/// The servo stands still: what keeps the arm from holding its last force is the device's thread.
TEST_P(ArmSafety, a_servo_that_hangs_leaves_no_force) {
  begin();
  press_in();
  loop->servo.stop();
  std::atomic<bool> hang{false};
  const Hand inner = loop->hand.hand();
  const Hand hanging{.sample =
                         [&](double dt) {
                           while (hang) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                           return inner.sample(dt);
                         },
                     .render = inner.render};
  loop->servo.start(PressedBlock::at_depth(0.002), hanging);
  ASSERT_TRUE(comes_true([&] { return pushed_back(); }));
  hang = true;
  EXPECT_TRUE(comes_true([&] { return force().isZero(0); }));
  hang = false;
  EXPECT_TRUE(comes_true([&] { return pushed_back(); }));
  loop->servo.stop();  // before what it calls goes
}

TEST_P(ArmSafety, garbage_ends_the_force_by_the_gate_and_what_is_true_again_begins_from_zero) {
  begin();
  press_in();
  standin->nan = true;
  ASSERT_TRUE(comes_true([&] { return let_go(Withheld::untrusted); }));
  Snapshot tick;
  while (loop->servo.next_tick(tick)) continue;
  standin->nan = false;
  ASSERT_TRUE(comes_true([&] { return pushed_back(); }));
  double first = 0;
  while (first == 0 && loop->servo.next_tick(tick)) first = tick.wrench.force.norm();
  EXPECT_LT(first, 0.9);
}

TEST_P(ArmSafety, a_handle_that_is_thrown_gets_nothing_until_it_has_left_the_contact) {
  // Up to 4 m/s to and fro along the block's top: 4 mm from one reading to the next.
  const auto along = [](int i) { return 0.004 * (std::abs((i + 30) % 120 - 60) - 30); };
  Vec3 at = Vec3::Zero();
  const auto throw_it = [&] {
    begin();
    press_in();
    return !HasFatalFailure() && on_and_on(
                                     [&](int i) {
                                       at = Vec3(along(i), 0, -0.003);
                                       move(at);
                                     },
                                     [&] { return let_go(Withheld::diverged); });
  };
  // A machine that does much else may hold up the thread that reads the arm: an arm that is not
  // heard of is not trusted, rightly, and it begins anew.
  bool thrown = false;
  for (int attempt = 0; attempt < 5 && !thrown; ++attempt) {
    thrown = throw_it();
    ASSERT_FALSE(HasFatalFailure());
    const std::uint64_t tick = loop->now().tick;
    ASSERT_TRUE(comes_true([&] { return loop->now().tick > tick + 200; }));
    if (loop->withheld() == Withheld::untrusted) thrown = false;
  }
  ASSERT_TRUE(thrown) << words(loop->withheld()) << loop->device->status().reason;
  EXPECT_TRUE(let_go(Withheld::diverged)) << "still in contact: " << words(loop->withheld());
  move({at.x(), 0, 0.001});
  ASSERT_TRUE(comes_true([&] { return trusted(); }));
  move({at.x(), 0, -0.003});
  EXPECT_TRUE(comes_true([&] { return pushed_back(); }));
}

TEST_P(ArmSafety, a_handle_that_is_thrown_into_a_turn_gets_nothing) {
  begin();
  press_in();
  standin->axis = maker.up;
  // Up to 60 rad/s about the block's normal, on the spot.
  const bool thrown = on_and_on([&](int i) { standin->angle = 0.06 * i; },
                                [&] { return let_go(Withheld::diverged); });
  EXPECT_TRUE(thrown) << words(loop->withheld()) << loop->device->status().reason;
}

TEST_P(ArmSafety, a_turn_as_of_a_hand_that_feels_something_is_no_divergence) {
  begin();
  press_in();
  standin->axis = maker.up;
  int readings = standin->frames;
  for (int i = 0; i < 200; ++i) {
    standin->angle = 0.005 * i;  // up to 5 rad/s
    ASSERT_TRUE(comes_true([&] { return standin->frames > readings; }));
    readings = standin->frames;
    EXPECT_NE(loop->withheld(), Withheld::diverged);
  }
  EXPECT_TRUE(comes_true([&] { return pushed_back(); }));
}

INSTANTIATE_TEST_SUITE_P(Makers, ArmSafety, testing::Values(force_dimension, three_d),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace sonde::test
