// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/haptics/hand/simulated_device.hpp"
#include "engine/settings/device_profile.hpp"
#include "tests/engine/haptics/loop/hand_loop_bench.hpp"

namespace sonde::test {

inline constexpr double most_speed = 0.1;  // m/s
inline constexpr double most_out = 2e-3;   // m, further than out of the contact

struct Grip {
  const char* name;
  double stiffness, damping;  // N/m, N·s/m
};
inline constexpr Grip grips[] = {
    {"light", 200, 1}, {"firm", 1000, 10}, {"released", 0, 0}, {"limp", 50, 0.2}};

inline SimulatedDeviceParameters held_by(const DeviceProfile& profile, const Grip& grip) {
  SimulatedDeviceParameters p = simulated(profile);
  const double per = profile.inertia.value / profile.mass.value;
  p.translation.hand_stiffness = grip.stiffness;
  p.translation.hand_damping = grip.damping;
  p.rotation.hand_stiffness = grip.stiffness * per;
  p.rotation.hand_damping = grip.damping * per;
  return p;
}

/// m/s: the closed form of how fast a hand's own spring K moves handle and hand once a force of
/// that size (N) that held them is gone: F/sqrt(K m) times what the damping leaves of it. What
/// friction takes is not counted.
inline double own_speed(const DeviceProfile& profile, const Grip& grip, double force) {
  const double m = profile.mass.value, natural = std::sqrt(grip.stiffness / m);
  const double z = (profile.damping.value + grip.damping) / (2 * m * natural);
  const double undamped = force / (m * natural);
  if (z == 1) return undamped * std::exp(-1.0);
  if (z < 1) {
    const double r = std::sqrt(1 - z * z);
    return undamped * std::exp(-z / r * std::atan2(r, z));
  }
  const double r = std::sqrt(z * z - 1);
  return undamped * std::exp(-z / r * std::atanh(r / z));
}

inline Coupling spring(double k) {
  Coupling c;
  c.k = k;
  return c;
}

/// How hard a hand presses, and the spring that it presses on.
struct Press {
  const char* name;
  double share, most;  ///< of the device's force that is asked of it; N
  double k;            ///< N/m
};
inline constexpr Press softly{"softly", 0.2, 1, 50};
inline constexpr Press presses[] = {softly, {"hard", 0.6, 6, 300}, {"too hard", 1.5, 15, 300}};

/// A hand that presses the bench's probe in, as the servo has it.
class Pressed {
 public:
  Pressed(const DeviceProfile& profile, const Grip& grip, const Press& press = softly,
          const HandLoopSettings& settings = {})
      : profile_(profile),
        device_(held_by(profile, grip), dt),
        gains_wanted_(spring(press.k)),
        glide_(gains_wanted_),
        bench_(settings, gains_wanted_, 1) {
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
    const double most = profile.max_force.value;
    const double asked = grip.stiffness > 0 ? std::min(press.share * most, press.most)
                                            : 0.8 * profile.friction.value;
    const double held = std::min({asked, most, gains_wanted_.max_force});
    press_in(asked / press.k, grip.stiffness > 0 ? held / grip.stiffness : 0);
    forget();
  }

  /// The gains that it began with.
  const Coupling& first() const { return gains_wanted_; }
  void set(const Coupling& coupling) { glide_.set(coupling); }
  /// What moved the handle until now does not count.
  void forget() {
    fastest_ = pushed_ = 0;
    highest_ = -1;
  }
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
      move(at_hand(bench_.loop.fade(sample, dt, time - i * dt).wrench));
    }
    EXPECT_EQ(force(), 0);
    bench_.loop.restart(probe());
  }
  /// Esc, or a fault: the force goes at once.
  void stop_force(double time) {
    forget();
    for (int i = 0; i < int(time / dt); ++i) {
      const HandSample sample{.X_FM = probe(), .device = traits_at_probe(traits_, ratio_, 1)};
      move(at_hand(bench_.tick(sample, true, Withheld::stopped).wrench));
    }
  }
  void pause(double time) {
    for (int i = 0; i < int(time / dt); ++i) {
      bench_.rest(Withheld::paused);
      move({});
    }
    forget();
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
      move(at_hand(done.wrench));
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
  /// At that depth the hand is as far from where it wants to be as its spring is pressed.
  void press_in(double depth, double pressed) {
    device_.reset(at_depth(0.001), target_ = at_depth(0.001));
    constexpr double time = 2;
    for (int i = 0; i < int(time / dt); ++i) {
      target_ = at_depth(0.001 + (depth + pressed - 0.001) * i * dt / time);
      if (!(pressed > 0)) device_.reset(target_, target_);  // nobody holds it
      run(1.5 * dt);
    }
    run(1);
  }
  Wrench at_hand(Wrench at_probe) const {
    at_probe.force *= ratio_;
    return at_probe;
  }
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
  Coupling gains_wanted_;
  GainGlide glide_;
  HandLoopBench bench_;
  Pose target_;
  GainGlide::Blend gains_;
  double fastest_ = 0, pushed_ = 0, highest_ = -1;
};

struct Event {
  const char* name;
  void (*happens)(Pressed&);
  double wall_goes = 0;  ///< m: so far away, that a hand presses on by itself
};
inline constexpr Event events[] = {
    {"a stiffer spring",
     [](Pressed& p) {
       Coupling c = p.first();
       c.k *= 8;
       p.set(c);
     }},
    {"another mode",
     [](Pressed& p) {
       Coupling c = p.first();
       c.mode = Coupling::Mode::classic;
       c.k_t = 8 * c.k;
       c.k_r = 0.02;
       p.set(c);
     }},
    {"a damper, of more than the device bears",
     [](Pressed& p) {
       Coupling c = p.first();
       c.mode = Coupling::Mode::damped;
       c.k *= 8;
       c.b_t = 100;
       p.know_damping();
       p.set(c);
     }},
    {"a spring with a damper, then without it",
     [](Pressed& p) {
       Coupling c = p.first();
       c.mode = Coupling::Mode::damped;
       c.k *= 8;
       c.b_t = 2;
       p.set(c);
       p.run(3);
       c.b_t = 0;
       p.set(c);
     }},
    {"a stiffer spring while the force is off",
     [](Pressed& p) {
       Coupling c = p.first();
       c.k *= 8;
       p.set(c);
       p.pause(3);
     }},
    {"a spring a hundred times as stiff",
     [](Pressed& p) {
       Coupling c = p.first();
       c.k *= 100;
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
     },
     0.005},
    {"half the scaling", [](Pressed& p) { p.scale(0.5); }},
    {"four times the scaling", [](Pressed& p) { p.scale(4); }},
    {"four times the scaling of a stiff spring, and back",
     [](Pressed& p) {
       Coupling c = p.first();
       c.k *= 8;
       p.set(c);
       p.run(3);
       p.scale(4);
       p.run(3);
       p.scale(1);
     }},
    {"a fifth of the scaling", [](Pressed& p) { p.scale(0.2); }},
    {"a tenth of the scaling", [](Pressed& p) { p.scale(0.1); }},
    {"a third of the largest force",
     [](Pressed& p) {
       Coupling c = p.first();
       c.max_force /= 3;
       p.set(c);
     }},
    {"a third of the largest force, at half the scaling",
     [](Pressed& p) {
       p.scale(0.5);
       p.run(0.02);
       Coupling c = p.first();
       c.max_force /= 3;
       p.set(c);
     }},
    {"another method or scene, from where the hand is", [](Pressed& p) { p.begin_anew(); }},
};

}  // namespace sonde::test
