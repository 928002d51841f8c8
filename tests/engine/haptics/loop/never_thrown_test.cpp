// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing but its own motion moves a hand fast: other gains, another mode, a force that comes back.
// Reference: the simulated device of each profile that ships, in the hands that a study has it in.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/haptics/loop/pressed.hpp"

namespace sonde::test {
namespace {

DeviceProfile profile_named(const char* id) {
  return read_device_profile(std::string(SONDE_RESOURCES "/devices/") + id + ".json");
}

struct PressingHand {
  const Grip& grip;
  const Press& press;
};
/// What nobody holds presses on nothing.
std::vector<PressingHand> hands() {
  std::vector<PressingHand> out;
  for (const Grip& grip : grips)
    for (const Press& press : presses)
      if (grip.stiffness > 0 || &press == presses) out.push_back({grip, press});
  return out;
}

class NeverThrown : public testing::TestWithParam<const char*> {};

TEST_P(NeverThrown, by_what_is_not_its_own_motion) {
  const DeviceProfile profile = profile_named(GetParam());
  double fastest = 0, out = 0;
  for (const auto& [grip, press] : hands()) {
    for (const Event& event : events) {
      SCOPED_TRACE(std::string(grip.name) + ", " + press.name + ", " + event.name);
      Pressed pressed(profile, grip, press);
      const double before = pressed.depth();
      ASSERT_GT(before, 0);
      event.happens(pressed);
      pressed.run(&press == presses ? 5 : 3);
      const double gone = grip.stiffness > 0 ? press.k * event.wall_goes : 0;
      // Both springs move it: the hand's, and that of the contact where it is now, which is late.
      const Grip both{grip.name, grip.stiffness + press.k,
                      grip.damping - press.k * (dt / 2 + profile.delay.value)};
      const double own = gone > 0 ? own_speed(profile, both, gone) : 0;
      EXPECT_LE(pressed.fastest(), std::max(most_speed, own));
      EXPECT_LE(pressed.highest(), most_out);
      fastest = std::max(fastest, pressed.fastest());
      out = std::max(out, pressed.highest());
    }
  }
  RecordProperty("fastest", std::to_string(fastest));
  RecordProperty("out", std::to_string(out));
}
// What takes the force off at once leaves the hand to its own spring, which is the bound there is.
TEST_P(NeverThrown, without_a_force_a_hand_moves_as_its_own_spring_makes_it) {
  const DeviceProfile profile = profile_named(GetParam());
  for (const auto& [grip, press] : hands()) {
    if (!(grip.stiffness > 0)) continue;
    SCOPED_TRACE(std::string(grip.name) + ", " + press.name);
    Pressed pressed(profile, grip, press);
    const double force = std::min(pressed.force(), profile.max_force.value);
    const double own = own_speed(profile, grip, force);
    pressed.stop_force(2);
    EXPECT_LE(pressed.fastest(), 1.01 * own);
    EXPECT_GE(pressed.fastest(), own_speed(profile, grip, force - 2 * profile.friction.value));
  }
}

TEST_P(NeverThrown, and_the_gains_do_change) {
  for (const Grip& grip : {grips[0], grips[1]})
    for (const std::size_t event : {0u, 1u}) {
      Pressed pressed(profile_named(GetParam()), grip);
      const double before = pressed.depth();
      ASSERT_GT(before, 5e-3);
      events[event].happens(pressed);
      pressed.run(5);
      EXPECT_LT(pressed.depth(), before);
      EXPECT_GT(pressed.depth(), 0) << "and it is still held";
    }
}

/// s: of half a tick, and from a sample to the motors.
double late_by(const DeviceProfile& p) { return dt / 2 + p.delay.value; }

/// Reference: K (T/2 + t_d) = b of mechanism and light hand; the probe feels k in translation, and
/// at most 1.2 kÎ in rotation.
double stable_without_damper(const DeviceProfile& p) {
  const double turn = body(box({0.02, 0.03, 0.05}))->mass.inertia.maxCoeff();
  const double most = (p.damping.value + 1) / late_by(p);
  if (!(p.max_torque.value > 0)) return most;
  const double turning = p.rotational_damping.value + p.inertia.value / p.mass.value;
  return std::min(most, turning / late_by(p) / (1.2 * turn));
}

TEST_P(NeverThrown, gains_beyond_the_stable_wait_until_the_contact_is_left) {
  const DeviceProfile p = profile_named(GetParam());
  const double most = stable_without_damper(p);
  Pressed pressed(p, grips[1]);
  Coupling stiff = spring(50);
  stiff.k = 20 * most;
  pressed.set(stiff);
  pressed.run(8);
  EXPECT_TRUE(pressed.waiting());
  EXPECT_NEAR(pressed.gains().k / std::max(most, 50.0), 1, 0.01);
  pressed.leave();
  pressed.run(1);
  EXPECT_FALSE(pressed.waiting());
  EXPECT_EQ(pressed.gains().k, stiff.k) << "wanted; what the device bears caps it in the loop";
}

TEST_P(NeverThrown, another_mode_beyond_the_stable_waits_and_a_softer_wish_does_not) {
  const DeviceProfile p = profile_named(GetParam());
  const double late = late_by(p), most = (p.damping.value + 1) / late;
  Pressed pressed(p, grips[1]);
  Coupling stiff = spring(50);
  stiff.mode = Coupling::Mode::classic;
  stiff.k_t = 20 * most;
  stiff.k_r = 1e-3;
  pressed.set(stiff);
  pressed.run(8);
  EXPECT_TRUE(pressed.waiting());
  const GainGlide::Blend& held = pressed.blend();
  ASSERT_LT(held.share, 1);
  // Both springs push the same way: what is felt is the sum of their shares.
  EXPECT_NEAR(held.share * held.now.k_t + (1 - held.share) * held.before.k, most, 0.01 * most);
  EXPECT_LE(pressed.pushed(), most_speed);
  Coupling careful = spring(50);
  careful.k = 100;
  pressed.set(careful);
  pressed.run(8);
  EXPECT_FALSE(pressed.waiting());
  EXPECT_EQ(pressed.gains().k, 100);
  pressed.set(stiff);
  pressed.run(8);
  EXPECT_TRUE(pressed.waiting());
  pressed.leave();
  pressed.run(1);
  EXPECT_FALSE(pressed.waiting());
  EXPECT_EQ(pressed.blend().share, 1);
  EXPECT_EQ(pressed.gains().k_t, stiff.k_t);
}

// A damper b in the same directions allows b / (T/2 + t_d) more.
TEST_P(NeverThrown, a_damper_that_the_spring_needs_stays_until_the_contact_is_left) {
  constexpr double b = 2, needed = 0.45;  // of it
  const DeviceProfile p = profile_named(GetParam());
  Pressed pressed(p, grips[1]);
  Coupling damped = spring(50);
  damped.mode = Coupling::Mode::damped;
  damped.k = stable_without_damper(p) + needed * b / late_by(p);
  damped.b_t = b;
  pressed.set(damped);
  pressed.run(8);
  EXPECT_FALSE(pressed.waiting());
  EXPECT_EQ(pressed.gains().k, damped.k);
  Coupling bare = damped;
  bare.b_t = 0;
  pressed.set(bare);
  pressed.run(3);
  EXPECT_TRUE(pressed.waiting());
  EXPECT_NEAR(pressed.gains().b_t, needed * b, 0.01 * b);
  EXPECT_LE(pressed.pushed(), most_speed);
  pressed.leave();
  pressed.run(1);
  EXPECT_FALSE(pressed.waiting());
  EXPECT_EQ(pressed.gains().b_t, 0);
}

INSTANTIATE_TEST_SUITE_P(Profiles, NeverThrown,
                         testing::Values("lambda.7", "omega.7", "premium-1.5-6dof",
                                         "premium-3.0-6dof", "sigma.7", "touch", "touch-x"));

/// m/s: how fast a hand that nothing protects is moved. A mass in the mechanism's and the hand's
/// damping and dry friction, between the hand's spring and a wall that is sampled, held and a tick
/// late, whose stiffness grows in a tenth of a second.
double thrown_speed_of_model(const DeviceProfile& device, const Grip& hand, double depth,
                             double target, double k_from, double k_to) {
  constexpr int parts = 20;
  constexpr double h = dt / parts;
  const double friction = device.friction.value, b = device.damping.value + hand.damping;
  double v = 0, fastest = 0, late = k_from * depth;
  for (int tick = 0; tick < 2000; ++tick) {
    const double k = k_from + (k_to - k_from) * std::min(1.0, tick * dt / 0.1);
    const double wall = std::exchange(late, k * std::max(0.0, depth));
    for (int i = 0; i < parts; ++i) {
      const double out = wall - hand.stiffness * (target - depth) - b * v;
      if (v == 0 && std::abs(out) <= friction) continue;
      const double drag = std::copysign(friction, v == 0 ? out : v);
      const double next = v + h * (out - drag) / device.mass.value;
      v = v * next < 0 ? 0 : next;
      depth -= h * v;
      fastest = std::max(fastest, std::abs(v));
    }
  }
  return fastest;
}

/// m/s: the same in the loop, where it has no rate of change.
double thrown_without_a_rate(const DeviceProfile& device, bool energy_is_damped) {
  HandLoopSettings settings;
  settings.safety.change_rate = {.force = 0, .torque = 0};
  settings.passivity.control = energy_is_damped;
  Pressed pressed(device, grips[0], softly, settings);
  events[0].happens(pressed);
  pressed.run(2);
  return pressed.fastest();
}

// What the rate is there for: without it, a tenth of a second of glide throws the light hand,
// beyond what NeverThrown allows; as fast as the model is thrown, but for the damping of the energy
// that the glide gives, which comes too late to hold it.
TEST(Thrown, without_a_rate_of_change) {
  const DeviceProfile device = profile_named("sigma.7");
  const Pressed before(device, grips[0]);
  const Coupling gains = before.first();
  const double target = softly.most / softly.k + softly.most / grips[0].stiffness;
  const double free =
      thrown_speed_of_model(device, grips[0], before.depth(), target, gains.k, 8 * gains.k);
  EXPECT_GT(free, 2 * most_speed);
  EXPECT_NEAR(thrown_without_a_rate(device, false) / free, 1, 0.01);
  const double damped = thrown_without_a_rate(device, true);
  RecordProperty("fastest", std::to_string(damped));
  EXPECT_GT(damped, 1.5 * most_speed);
  EXPECT_LT(damped, free);
}

/// N: the largest change of the force from tick to tick while a hand strikes at 0.3 m/s. Before,
/// the contact gave it energy, which the loop then owes, by a jump.
double largest_change_of_a_strike(double most_force, double max_damping) {
  HandLoopSettings settings;
  settings.safety.ramp_time = 0;
  HandLoopBench bench(settings, spring(50));
  const DeviceTraits traits{.max_damping = max_damping, .max_force = most_force, .mass = 0.2};
  const auto at = [&](double depth) -> const HandTick& {
    return bench.tick({.X_FM = at_depth(depth), .device = traits});
  };
  bench.loop.set_passivity_control(false);
  for (int i = 0; i < 2000; ++i) at(0.002);
  bench.raised = 0.01;
  for (int i = 0; i < 1000; ++i) at(0.002);
  for (int i = 0; i < 300; ++i) at(0.002 - 5e-5 * i);  // out of the contact, and pushed
  EXPECT_GT(bench.loop.last().hand.energy.excess, 1e-4);
  bench.loop.set_passivity_control(true);
  double largest = 0, before = 0, damping = 0;
  for (int i = 0; i < 20; ++i) {
    const double force = at(-0.0131 + 3e-4 * i).wrench.force.z();
    largest = std::max(largest, std::abs(force - before));
    before = force;
    damping = std::max(damping, bench.loop.last().hand.energy.damping);
  }
  EXPECT_GT(damping, 1);
  return largest;
}

// A tenth of the device's force for what the spring and a tenth for what the damping may add.
TEST(Thrown, not_by_the_damping_of_what_a_contact_gave) {
  for (const double most : {1.0, 3.3, 12.0})
    for (const double damping : {4.0, 30.0})
      EXPECT_LE(largest_change_of_a_strike(most, damping), 0.2 * most + 0.02) << most;
}

}  // namespace
}  // namespace sonde::test
