// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing but its own motion moves a hand fast: other gains, another mode, a force that comes back.
// Reference: the simulated device of each profile that ships, in the hands that a study has it in.
#include <gtest/gtest.h>

#include <string>

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
constexpr Grip grips[] = {{"light", 200, 1}, {"firm", 1000, 10}};

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
      : device_(held(profile, grip), dt), glide_(soft()), bench_(settings, soft()) {
    const double force = std::min(1.0, 0.2 * profile.max_force.value);
    target_ = at_depth(force / 50 + force / grip.stiffness);
    device_.reset(at_depth(force / 50), target_);
    run(4);
    fastest_ = 0;
  }

  void set(const Coupling& coupling) { glide_.set(coupling); }
  void pause(double time) {
    for (int i = 0; i < int(time / dt); ++i) {
      bench_.rest(Withheld::paused);
      move({});
    }
    fastest_ = 0;
  }
  void run(double time) {
    for (int i = 0; i < int(time / dt); ++i) {
      bench_.loop.set_coupling(glide_.next(dt, bench_.loop.most_of_glide(glide_, dt)));
      move(bench_.tick({.X_FM = device_.measured(), .device = DeviceTraits{}}).wrench);
    }
  }
  double fastest() const { return fastest_; }
  double depth() const { return at_depth(0).p.z() - device_.state().X_WD.p.z(); }
  double highest() const { return highest_ - at_depth(0).p.z(); }

 private:
  void move(const Wrench& wrench) {
    device_.step(wrench, target_);
    fastest_ = std::max(fastest_, device_.state().velocity.norm());
    highest_ = std::max(highest_, device_.state().X_WD.p.z());
  }

  SimulatedDevice device_;
  GainGlide glide_;
  HandLoopBench bench_;
  Pose target_;
  double fastest_ = 0, highest_ = -1;
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
    {"a stiffer spring while the force is off",
     [](Pressed& p) {
       Coupling c = soft();
       c.k = 400;
       p.set(c);
       p.pause(0.3);
     }},
};

DeviceProfile profile_named(const char* id) {
  return read_device_profile(std::string(SONDE_RESOURCES "/devices/") + id + ".json");
}

class NeverThrown : public testing::TestWithParam<const char*> {};

TEST_P(NeverThrown, by_what_is_not_its_own_motion) {
  const DeviceProfile profile = profile_named(GetParam());
  for (const Grip& grip : grips)
    for (const Event& event : events) {
      SCOPED_TRACE(std::string(grip.name) + ", " + event.name);
      Pressed pressed(profile, grip);
      const double before = pressed.depth();
      ASSERT_GT(before, 5e-3);
      event.happens(pressed);
      pressed.run(5);
      EXPECT_LE(pressed.fastest(), most_speed);
      EXPECT_LE(pressed.highest(), most_out);
      EXPECT_LT(pressed.depth(), before) << "the gains did change";
      EXPECT_GT(pressed.depth(), 0) << "and it is still held";
    }
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

}  // namespace
}  // namespace sonde::test
