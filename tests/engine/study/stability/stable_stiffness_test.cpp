// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/stable_stiffness.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/study/stability/sampled_stability.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A box on a slab, and the ways of a device down to it.
RenderSetup pressed_box() {
  RenderSetup out{
      Pair(test::body(test::box({0.06, 0.05, 0.04})), test::body(test::box({0.3, 0.3, 0.1})))};
  out.coupling.k = 1000;
  return out;
}
std::vector<TimedPose> way_down(double from, double to) {
  std::vector<TimedPose> out;
  for (int i = 0; i <= 20; ++i)
    out.push_back({1e-3 * i, {Quat::Identity(), {0.01, 0.02, 0.07 + from + (to - from) * i / 20}}});
  return out;
}
/// A handle without a hand.
SimulatedDeviceParameters damped_handle() {
  SimulatedDeviceParameters out;
  out.translation = {.inertia = 0.1, .damping = 2};
  out.rotation = {.inertia = 5e-5, .damping = 1e-3};
  return out;
}

// Reference: one axis in a closed loop, across the slab: the only one in which PD_t pushes. Passive
// below 2 b / T (Colgate and Schenkel, 1997). The felt stiffness is measured by differences.
TEST(StableStiffness, of_a_translation_is_that_of_one_axis) {
  const double tick = 1e-3;
  const SimulatedDeviceParameters device = damped_handle();
  const StableStiffness found = stable_stiffness(pressed_box(), Method::pdt, way_down(1e-3, -4e-3),
                                                 device, tick, test::never);
  ASSERT_TRUE(found.stable);
  EXPECT_NEAR(*found.stable / largest_stable_stiffness({0.1, 2, 0, tick, 0}), 1, 1e-3);
  ASSERT_TRUE(found.passive_in_translation);
  EXPECT_NEAR(*found.passive_in_translation / (2 * 2 / tick), 1, 1e-3);
  // It does not depend on the gain that is asked for.
  RenderSetup softer = pressed_box();
  softer.coupling.k = 300;
  const StableStiffness same =
      stable_stiffness(softer, Method::pdt, way_down(1e-3, -4e-3), device, tick, test::never);
  EXPECT_NEAR(*same.stable / *found.stable, 1, 1e-3);
}

// Reference: the force is that stiffness times the depth, which is known at every tick.
TEST(StableStiffness, forces_at_the_limit_are_the_stiffness_times_the_depth) {
  const auto path = way_down(1e-3, -4e-3);
  const StableStiffness found =
      stable_stiffness(pressed_box(), Method::pdt, path, damped_handle(), 1e-3, test::never);
  ASSERT_GT(found.limits.size(), 8u);
  ASSERT_LE(found.limits.size(), limits_looked_at);
  for (const StableStiffness::ForceAtLimit& limit : found.limits) {
    const double depth = 0.07 - path[limit.tick].pose.p.z();
    EXPECT_GT(depth, 0);
    EXPECT_NEAR(limit.force / (*found.stable * depth), 1, 1e-3) << limit.tick;
  }
}

TEST(StableStiffness, a_path_without_contact_has_no_limit) {
  const StableStiffness found = stable_stiffness(pressed_box(), Method::pdg, way_down(0.02, 0.01),
                                                 damped_handle(), 1e-3, test::never);
  EXPECT_FALSE(found.stable);
  EXPECT_FALSE(found.passive);
  EXPECT_FALSE(found.passive_in_translation);
  EXPECT_EQ(found.cycle_lever, 0);
  EXPECT_TRUE(found.limits.empty());
}

TEST(StableStiffness, can_be_cancelled) {
  EXPECT_THROW(stable_stiffness(pressed_box(), Method::pdg, way_down(1e-3, -4e-3), damped_handle(),
                                1e-3, [] { return true; }),
               Cancelled);
}

TEST(StableStiffness, comes_back_from_its_text_to_the_bit) {
  const StableStiffness written{1.0 / 3, std::nullopt, 0.0, 1e-17, {{3, 0.1}, {40, 2.0 / 7}}};
  const StableStiffness read = stable_stiffness_of(to_json(written), "made-up");
  EXPECT_EQ(read.stable, written.stable);
  EXPECT_EQ(read.passive, written.passive);
  EXPECT_EQ(read.passive_in_translation, written.passive_in_translation);
  EXPECT_EQ(read.cycle_lever, written.cycle_lever);
  ASSERT_EQ(read.limits.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.limits[i].tick, written.limits[i].tick);
    EXPECT_EQ(read.limits[i].force, written.limits[i].force);
  }
}

TEST(StableStiffness, text_that_holds_none_is_refused_by_its_source) {
  for (const char* text : {"", "no", "[1]", R"({"stable": "x"})", R"({"limits": [[1]]})"}) {
    try {
      stable_stiffness_of(text, "made-up");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("made-up: holds no stiffness")) << text;
    }
  }
}

}  // namespace
}  // namespace sonde
