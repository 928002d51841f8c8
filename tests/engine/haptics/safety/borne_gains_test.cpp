// SPDX-License-Identifier: GPL-3.0-or-later
// References: the largest gains of the header, by hand; K (T/2 + t_d) = b; the eigenvalues of one
// sampled axis.
#include "engine/haptics/safety/borne_gains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/geometry/random.hpp"
#include "engine/study/stability/sampled_stability.hpp"

namespace sonde {
namespace {

MassProperties long_probe() {
  MassProperties mass;
  mass.inertia = {1e-5, 2e-5, 2e-4};
  return mass;
}

Coupling all_at(Coupling::Mode mode, double value) {
  return {.mode = mode, .k = value, .k_t = value, .k_r = value, .b_t = value, .b_r = value};
}

TEST(BorneGains, each_is_no_more_than_the_device_bears) {
  const BorneGains most{
      .translation = 3000, .rotation = 0.6, .damping = 20, .rotational_damping = 0.002};
  const Coupling classic = borne(all_at(Coupling::Mode::classic, 1e4), most, long_probe());
  EXPECT_EQ(classic.k_t, 3000);
  EXPECT_EQ(classic.k_r, 0.6);
  EXPECT_EQ(classic.b_t, 20);
  EXPECT_EQ(classic.b_r, 0.002);
  // One gain for both: felt in a turn as up to 1.2 times the largest moment of inertia.
  const Coupling damped = borne(all_at(Coupling::Mode::damped, 1e4), most, long_probe());
  EXPECT_DOUBLE_EQ(damped.k, 0.6 / (1.2 * 2e-4));
  EXPECT_DOUBLE_EQ(damped.b_t, 0.002 / (1.2 * 2e-4));
  const Coupling little = borne(all_at(Coupling::Mode::damped, 1e-3), most, long_probe());
  EXPECT_EQ(little.k, 1e-3);
  EXPECT_EQ(little.b_t, 1e-3);
}

TEST(BorneGains, what_is_not_known_limits_nothing) {
  for (const auto mode :
       {Coupling::Mode::object, Coupling::Mode::classic, Coupling::Mode::damped}) {
    const Coupling wanted = all_at(mode, 1e4), got = borne(wanted, {}, long_probe());
    EXPECT_EQ(got.k, 1e4);
    EXPECT_EQ(got.k_t, 1e4);
    EXPECT_EQ(got.b_t, 1e4);
    EXPECT_EQ(got.b_r, 1e4);
    EXPECT_FALSE(is_reduced(got, wanted));
  }
}

TEST(BorneGains, reduced_is_what_the_mode_uses) {
  const BorneGains little_damping{.damping = 1};
  const auto reduced = [&](Coupling::Mode mode) {
    const Coupling wanted = all_at(mode, 2);
    return is_reduced(borne(wanted, little_damping, long_probe()), wanted);
  };
  EXPECT_FALSE(reduced(Coupling::Mode::object)) << "it has no damper";
  EXPECT_TRUE(reduced(Coupling::Mode::damped));
  EXPECT_TRUE(reduced(Coupling::Mode::classic));
}

TEST(BorneGains, a_device_bears_what_its_maker_states) {
  const BorneGains most = borne_by_device({.max_damping = 3,
                                           .max_rotational_damping = 0.01,
                                           .max_stiffness = 2000,
                                           .max_rotational_stiffness = 5});
  EXPECT_EQ(most.translation, 2000);
  EXPECT_EQ(most.rotation, 5);
  EXPECT_EQ(most.damping, 3);
  EXPECT_EQ(most.rotational_damping, 0.01);
}

constexpr double servo_tick = 1e-3;

TEST(BorneGains, the_estimate_is_that_of_one_sampled_axis_in_a_light_hand) {
  const BorneGains stable =
      stable_by_estimate({.damping = 2, .delay = 1e-3}, servo_tick, {}, long_probe());
  EXPECT_DOUBLE_EQ(stable.translation, (2 + 1) / 1.5e-3);
  EXPECT_EQ(stable.rotation, 0) << "no motor turns it";
  EXPECT_EQ(stable.damping, 0) << "it says nothing of damping";
  EXPECT_DOUBLE_EQ(stable_by_estimate({}, servo_tick, {}, long_probe()).translation, 1 / 0.5e-3)
      << "the hand alone";
  EXPECT_EQ(stable_by_estimate({.force = false}, servo_tick, {}, long_probe()).translation, 0)
      << "nothing moves it";
}

TEST(BorneGains, a_device_that_reports_less_often_is_later) {
  const DeviceTraits slow{.damping = 2, .delay = 1e-3, .period = 4e-3};
  EXPECT_DOUBLE_EQ(stable_by_estimate(slow, servo_tick, {}, long_probe()).translation,
                   (2 + 1) / 3e-3);
  const DeviceTraits quick{.damping = 2, .delay = 1e-3, .period = 1e-4};
  EXPECT_DOUBLE_EQ(stable_by_estimate(quick, servo_tick, {}, long_probe()).translation,
                   (2 + 1) / 1.5e-3)
      << "the servo asks no more often";
}

TEST(BorneGains, of_an_unknown_device_the_least_is_assumed_at_its_handle) {
  const DeviceTraits unknown{.ratio = 2, .turn_ratio = 1, .max_torque = 1, .known = false};
  const BorneGains stable = stable_by_estimate(unknown, servo_tick, {}, long_probe());
  EXPECT_DOUBLE_EQ(stable.translation, (0.2 / 4 + 1) / 1.5e-3);
  EXPECT_DOUBLE_EQ(stable.rotation, (1e-4 + 5e-5 / (0.05 / 4)) / 1.5e-3);
  DeviceTraits assumed{.damping = 2, .delay = 1e-3, .mass = 0.3, .known = false};
  EXPECT_DOUBLE_EQ(stable_by_estimate(assumed, servo_tick, {}, long_probe()).translation,
                   3 / 1.5e-3)
      << "what its profile assumes comes first";
  DeviceTraits no_torque = unknown;
  no_torque.max_torque = 0;
  EXPECT_EQ(stable_by_estimate(no_torque, servo_tick, {}, long_probe()).rotation, 0);
}

/// Evenly by ratio.
double between(Random& random, double low, double high) {
  return low * std::exp(random.uniform(0, std::log(high / low)));
}

// None of the devices that ship. A damper is late itself; more than is counted only allows more, up
// to some m/(T + t_d), where it swings by itself.
TEST(BorneGains, with_a_damper_the_estimate_is_at_most_a_fifth_above_the_eigenvalues) {
  Random random(5);
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    const double tick = between(random, 2.5e-4, 2e-3), delay = between(random, 1e-4, 5e-3);
    const double mass = between(random, 0.02, 2), inertia = between(random, 2e-5, 2e-3);
    const double own = between(random, 0.01, 0.1) / (tick + delay);
    const double coupled = between(random, 0.01, 1) / (tick + delay);
    const DeviceTraits device{.damping = own * mass,
                              .delay = delay,
                              .rotational_damping = own * inertia,
                              .mass = mass,
                              .inertia = inertia};
    const double B = coupled * mass, turn_B = coupled * inertia;
    const BorneGains got = stable_by_estimate(
        device, tick, {.mode = Coupling::Mode::classic, .b_t = B, .b_r = turn_B}, long_probe());
    const double hand = 1, turn_hand = hand * inertia / mass;
    const double exact = largest_stable_stiffness({mass, device.damping + hand, B, tick, delay});
    const double turning = largest_stable_stiffness(
        {inertia, device.rotational_damping + turn_hand, turn_B, tick, delay});
    worst = std::max({worst, got.translation / exact, got.rotation / turning});
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_GT(worst, 1) << "none were near the limit";
  EXPECT_LT(worst, 1.2);
}

TEST(BorneGains, a_damper_for_a_handle_of_unknown_mass_is_not_counted) {
  const DeviceTraits device{.damping = 2, .delay = 1e-3};
  EXPECT_EQ(stable_by_estimate(device, servo_tick, all_at(Coupling::Mode::classic, 3), long_probe())
                .translation,
            stable_by_estimate(device, servo_tick, all_at(Coupling::Mode::classic, 0), long_probe())
                .translation);
}

Coupling in_norm(Coupling::Mode mode, double k, double b = 0) {
  return {.mode = mode, .k = k, .b_t = b};
}

double share(const Coupling& from, const Coupling& to) {
  GainGlide glide(from);
  glide.set(to);
  // 2000 N/m without a damper, 667 more for 1 N·s/m; and no limit of rotation.
  return share_of_way(glide, {.damping = 2, .delay = 1e-3, .mass = 0.3}, servo_tick, long_probe());
}

TEST(BorneGains, a_stiffness_above_its_limit_waits) {
  for (const auto from : {Coupling::Mode::object, Coupling::Mode::damped})
    for (const auto to : {Coupling::Mode::object, Coupling::Mode::damped})
      EXPECT_NEAR(share(in_norm(from, 1500), in_norm(to, 3500)), 0.25, 1e-12);
  EXPECT_EQ(share(in_norm(Coupling::Mode::object, 500), in_norm(Coupling::Mode::object, 2000)), 1);
  EXPECT_EQ(share(in_norm(Coupling::Mode::object, 9000), in_norm(Coupling::Mode::object, 8000)), 1);
  EXPECT_EQ(share(in_norm(Coupling::Mode::object, 8000), in_norm(Coupling::Mode::object, 9000)), 0);
}

Coupling classic(double k_t, double b_t = 0) {
  return {.mode = Coupling::Mode::classic, .k_t = k_t, .b_t = b_t};
}

// Half of each spring is felt half way, so 2000 N/m are reached where the lines cross.
TEST(BorneGains, a_change_of_mode_waits_as_gains_do) {
  const auto object = Coupling::Mode::object;
  EXPECT_NEAR(share(in_norm(object, 1500), classic(3500)), 0.25, 1e-12);
  EXPECT_NEAR(share(classic(1500), in_norm(object, 3500)), 0.25, 1e-12);
  EXPECT_EQ(share(in_norm(object, 1500), classic(1900)), 1);
  EXPECT_EQ(share(in_norm(object, 9000), classic(1900)), 1) << "to what is stable";
  EXPECT_EQ(share(in_norm(object, 9000), classic(9500)), 0);
  EXPECT_NEAR(share(classic(3000, 3), in_norm(object, 3000)), 0.5, 1e-12) << "loses its damper";
}

TEST(BorneGains, a_damper_lets_its_spring_by_and_waits_where_it_is_needed) {
  const auto object = Coupling::Mode::object, damped = Coupling::Mode::damped;
  EXPECT_EQ(share(in_norm(object, 500), in_norm(damped, 3900, 3)), 1) << "stable thanks to it";
  EXPECT_NEAR(share(in_norm(damped, 3000, 3), in_norm(object, 3000)), 0.5, 1e-12);
  EXPECT_NEAR(share(in_norm(damped, 3000, 3), in_norm(damped, 3000, 0)), 0.5, 1e-12);
  EXPECT_EQ(share(in_norm(damped, 1900, 3), in_norm(object, 1900)), 1) << "not needed";
  EXPECT_EQ(share(in_norm(damped, 3000, 3), in_norm(object, 1900)), 1) << "falls with the spring";
}

}  // namespace
}  // namespace sonde
