// SPDX-License-Identifier: GPL-3.0-or-later
// References: the largest gains of the header, by hand; K (T/2 + t_d) = b.
#include "engine/haptics/safety/borne_gains.hpp"

#include <gtest/gtest.h>

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

TEST(BorneGains, the_estimate_is_that_of_one_sampled_axis_in_a_light_hand) {
  const BorneGains stable = stable_by_estimate({.damping = 2, .delay = 1e-3}, 1e-3);
  EXPECT_DOUBLE_EQ(stable.translation, (2 + 1) / 1.5e-3);
  EXPECT_EQ(stable.rotation, 0) << "no motor turns it";
  EXPECT_EQ(stable.damping, 0) << "it says nothing of damping";
  EXPECT_EQ(stable_by_estimate({}, 1e-3).translation, 0);
}

TEST(BorneGains, a_damper_does_not_let_an_unstable_spring_through) {
  const BorneGains most{.translation = 1000};
  for (const auto from : {Coupling::Mode::object, Coupling::Mode::damped})
    for (const auto to : {Coupling::Mode::object, Coupling::Mode::damped}) {
      GainGlide glide(all_at(from, 500));
      glide.set(all_at(to, 2500));
      EXPECT_DOUBLE_EQ(share_of_way(glide, most, long_probe()), 0.25);
    }
}

}  // namespace
}  // namespace sonde
