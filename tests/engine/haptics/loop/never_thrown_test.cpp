// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing but its own motion moves a hand fast: other gains, another mode, a force that comes back.
// Reference: the simulated device of each profile that ships, in the hands that a study has it in.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/settings/device_profile.hpp"
#include "tests/engine/haptics/loop/hand_loop_bench.hpp"

namespace sonde::test {
namespace {

constexpr double most_speed = 0.1;  // m/s
constexpr double most_out = 2e-3;   // m, further than out of the contact

struct Grip {
  const char* name;
  double stiffness, damping;  // N/m, N·s/m
};
constexpr Grip grips[] = {
    {"light", 200, 1}, {"firm", 1000, 10}, {"released", 0, 0}, {"limp", 50, 0.2}};

SimulatedDeviceParameters held(const DeviceProfile& profile, const Grip& grip) {
  SimulatedDeviceParameters p = simulated(profile);
  const double per = profile.inertia.value / profile.mass.value;
  p.translation.hand_stiffness = grip.stiffness;
  p.translation.hand_damping = grip.damping;
  p.rotation.hand_stiffness = grip.stiffness * per;
  p.rotation.hand_damping = grip.damping * per;
  return p;
}

Coupling soft() {
  Coupling c;
  c.k = 50;
  return c;
}

/// A hand that presses the bench's probe in, as the servo has it.
class Pressed {
 public:
  Pressed(const DeviceProfile& profile, const Grip& grip, const HandLoopSettings& settings = {})
      : profile_(profile),
        device_(held(profile, grip), dt),
        glide_(soft()),
        bench_(settings, soft()) {
    traits_.damping = profile.damping.value;
    if (profile.max_torque.value > 0) traits_.rotational_damping = profile.rotational_damping.value;
    traits_.delay = profile.delay.value;
    traits_.mass = profile.mass.value;
    traits_.inertia = profile.inertia.value;
    traits_.max_force = profile.max_force.value;
    traits_.max_torque = profile.max_torque.value;
    traits_.max_stiffness = profile.max_stiffness.value;
    traits_.max_rotational_stiffness = profile.max_rotational_stiffness.value;
    // What nobody holds stays in the contact only by the friction of the mechanism.
    const double force = grip.stiffness > 0 ? std::min(1.0, 0.2 * profile.max_force.value)
                                            : 0.8 * profile.friction.value;
    target_ = at_depth(force / 50 + (grip.stiffness > 0 ? force / grip.stiffness : 0));
    device_.reset(at_depth(force / 50), target_);
    run(4);
    fastest_ = pushed_ = 0;
  }

  void set(const Coupling& coupling) { glide_.set(coupling); }
  /// From now on the device says what damping it bears, as a profile does.
  void know_damping() {
    traits_.max_damping = profile_.max_damping.value;
    traits_.max_rotational_damping = profile_.max_rotational_damping.value;
  }
  /// The device reads so much too far, for a tick.
  void misread(double by) { misread_ = by; }
  /// The probe moves so much further than the hand, from now on.
  void scale(double ratio) {
    probe_from_ = probe().p;
    hand_from_ = device_.measured().p;
    rescaled_ *= ratio / ratio_;
    ratio_ = ratio;
  }
  /// The device reads so much too far, from now on.
  void lift(double by) { lifted_ = by; }
  /// The fixed body is so much higher, from now on: the contact jumps.
  void raise(double by) { bench_.raised = by; }
  /// Another scene or method: the loop begins anew where the hand is.
  void begin_anew() {
    constexpr double time = HandLoop::longest_fade;
    for (int i = 0; i < int(time / dt); ++i) {
      const HandSample sample{.X_FM = probe(), .device = traits_at_probe(traits_, ratio_, 1)};
      move(bench_.loop.fade(sample, dt, time - i * dt).wrench);
    }
    EXPECT_EQ(force(), 0);
    bench_.loop.restart(probe());
  }
  void pause(double time) {
    for (int i = 0; i < int(time / dt); ++i) {
      bench_.rest(Withheld::paused);
      move({});
    }
    fastest_ = pushed_ = 0;
  }
  void run(double time) {
    for (int i = 0; i < int(time / dt); ++i) {
      const GainGlide::Blend& blend = glide_.next(dt, bench_.loop.most_of_glide(glide_, dt));
      gains_ = blend;
      bench_.loop.set_coupling(blend);
      HandSample sample{.X_FM = probe(), .device = traits_at_probe(traits_, ratio_, 1)};
      sample.rescaled = std::exchange(rescaled_, 1);
      sample.X_FM.p.z() -= std::exchange(misread_, 0) + lifted_;
      const HandTick& done = bench_.tick(sample);
      waiting_ = done.hand.waiting;
      Wrench on_hand = done.wrench;
      on_hand.force *= ratio_;
      move(on_hand);
    }
  }
  const Coupling& gains() const { return gains_.now; }
  const GainGlide::Blend& blend() const { return gains_; }
  void leave() { target_ = at_depth(-0.02); }
  double fastest() const { return fastest_; }
  double pushed() const { return pushed_; }
  bool waiting() const { return waiting_; }
  double force() const { return bench_.loop.last().wrench.force.norm(); }
  double depth() const { return at_depth(0).p.z() - probe().p.z(); }
  /// m: how far out of the contact the hand was.
  double highest() const { return highest_ - (lifted_ + bench_.raised) / ratio_; }

 private:
  Pose probe() const {
    Pose out = device_.measured();
    out.p = probe_from_ + ratio_ * (out.p - hand_from_);
    return out;
  }
  void move(const Wrench& wrench) {
    device_.step(wrench, target_);
    fastest_ = std::max(fastest_, device_.state().velocity.norm());
    pushed_ = std::max(pushed_, device_.state().velocity.z());  // the way the force pushes
    highest_ = std::max(highest_, -depth() / ratio_);
  }

  DeviceProfile profile_;
  DeviceTraits traits_;
  double ratio_ = 1, rescaled_ = 1, misread_ = 0, lifted_ = 0;
  Vec3 probe_from_ = Vec3::Zero(), hand_from_ = Vec3::Zero();
  bool waiting_ = false;
  SimulatedDevice device_;
  GainGlide glide_;
  HandLoopBench bench_;
  Pose target_;
  GainGlide::Blend gains_;
  double fastest_ = 0, pushed_ = 0, highest_ = -1;
};

struct Event {
  const char* name;
  void (*happens)(Pressed&);
};
constexpr Event events[] = {
    {"a stiffer spring",
     [](Pressed& p) {
       Coupling c = soft();
       c.k = 400;
       p.set(c);
     }},
    {"another mode",
     [](Pressed& p) {
       Coupling c = soft();
       c.mode = Coupling::Mode::classic;
       c.k_t = 400;
       c.k_r = 0.02;
       p.set(c);
     }},
    {"a damper, of more than the device bears",
     [](Pressed& p) {
       Coupling c = soft();
       c.mode = Coupling::Mode::damped;
       c.k = 400;
       c.b_t = 100;
       p.know_damping();
       p.set(c);
     }},
    {"a spring with a damper, then without it",
     [](Pressed& p) {
       Coupling c = soft();
       c.mode = Coupling::Mode::damped;
       c.k = 400;
       c.b_t = 2;
       p.set(c);
       p.run(3);
       c.b_t = 0;
       p.set(c);
     }},
    {"a stiffer spring while the force is off",
     [](Pressed& p) {
       Coupling c = soft();
       c.k = 400;
       p.set(c);
       p.pause(0.3);
     }},
    {"a spring a hundred times as stiff",
     [](Pressed& p) {
       Coupling c = soft();
       c.k = 5000;
       p.set(c);
     }},
    {"a pose 15 mm too deep, for a tick", [](Pressed& p) { p.misread(0.015); }},
    {"a pose 15 mm too high, for a tick", [](Pressed& p) { p.misread(-0.015); }},
    {"a pose 5 mm too deep, from now on", [](Pressed& p) { p.lift(0.005); }},
    {"a contact that jumps by 2 mm", [](Pressed& p) { p.raise(0.002); }},
    {"a contact that jumps by 5 mm", [](Pressed& p) { p.raise(0.005); }},
    {"a contact that jumps by 10 mm", [](Pressed& p) { p.raise(0.01); }},
    {"a contact that jumps away by 5 mm, and back",
     [](Pressed& p) {
       p.raise(-0.005);
       p.run(0.2);
       p.raise(0);
     }},
    {"half the scaling", [](Pressed& p) { p.scale(0.5); }},
    {"four times the scaling", [](Pressed& p) { p.scale(4); }},
    {"four times the scaling of a stiff spring, and back",
     [](Pressed& p) {
       Coupling c = soft();
       c.k = 400;
       p.set(c);
       p.run(3);
       p.scale(4);
       p.run(3);
       p.scale(1);
     }},
    {"a fifth of the scaling", [](Pressed& p) { p.scale(0.2); }},
    {"another method or scene, from where the hand is", [](Pressed& p) { p.begin_anew(); }},
};

DeviceProfile profile_named(const char* id) {
  return read_device_profile(std::string(SONDE_RESOURCES "/devices/") + id + ".json");
}

class NeverThrown : public testing::TestWithParam<const char*> {};

TEST_P(NeverThrown, by_what_is_not_its_own_motion) {
  const DeviceProfile profile = profile_named(GetParam());
  double fastest = 0, out = 0;
  for (const Grip& grip : grips) {
    for (const Event& event : events) {
      SCOPED_TRACE(std::string(grip.name) + ", " + event.name);
      Pressed pressed(profile, grip);
      const double before = pressed.depth();
      ASSERT_GT(before, 0);
      event.happens(pressed);
      pressed.run(5);
      EXPECT_LE(pressed.fastest(), most_speed);
      EXPECT_LE(pressed.highest(), most_out);
      fastest = std::max(fastest, pressed.fastest());
      out = std::max(out, pressed.highest());
    }
  }
  RecordProperty("fastest", std::to_string(fastest));
  RecordProperty("out", std::to_string(out));
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
  Coupling stiff = soft();
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
  Coupling stiff = soft();
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
  Coupling careful = soft();
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
  Coupling damped = soft();
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

// What the rate is there for: without it, a tenth of a second of glide throws the light hand.
TEST(Thrown, without_a_rate_of_change) {
  HandLoopSettings settings;
  settings.safety.change_rate = {.force = 0, .torque = 0};
  Pressed pressed(profile_named("sigma.7"), grips[0], settings);
  events[0].happens(pressed);
  pressed.run(2);
  RecordProperty("fastest", std::to_string(pressed.fastest()));
  EXPECT_GT(pressed.fastest(), 2 * most_speed);
}

/// N: the largest change of the force from tick to tick while a hand strikes at 0.3 m/s. Before,
/// the contact gave it energy, which the loop then owes, by a jump.
double largest_change_of_a_strike(double most_force, double max_damping) {
  HandLoopSettings settings;
  settings.safety.ramp_time = 0;
  HandLoopBench bench(settings, soft());
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
