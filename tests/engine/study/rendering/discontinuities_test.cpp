// SPDX-License-Identifier: GPL-3.0-or-later
// Renderings made up by hand: what counts and what does not is known.
#include "engine/study/rendering/discontinuities.hpp"

#include <gtest/gtest.h>

namespace sonde {
namespace {

constexpr double k = 1000, radius = 0.05, stride = 1e-4;

/// In contact, depth along the force.
RenderedTick tick(const Vec3& force, const Vec3& torque = Vec3::Zero()) {
  RenderedTick out;
  out.moved = stride;
  out.force = force;
  out.torque = torque;
  out.depth = force.norm() / k;
  return out;
}

Discontinuities of(const Rendering& rendering) { return discontinuities(rendering, k, radius); }

TEST(Discontinuities, a_following_force_has_none) {
  Rendering press;
  for (int i = 0; i < 100; ++i) press.push_back(tick({0, 0, 0.05 * i}, {0.001 * i, 0, 0}));
  const Discontinuities d = of(press);
  EXPECT_EQ(d.force_steps + d.torque_steps + d.jumps + d.pop_throughs, 0);
  EXPECT_NEAR(d.largest_force_step, 0.05, 1e-12);
  EXPECT_NEAR(d.largest_torque_step, 0.001, 1e-12);
}

TEST(Discontinuities, a_force_step_is_more_than_twice_what_the_device_moved) {
  const double most = 2 * k * stride;
  EXPECT_EQ(of({tick({0, 0, 5}), tick({0, 0, 5 - 0.99 * most})}).force_steps, 0);
  EXPECT_EQ(of({tick({0, 0, 5}), tick({1.05 * most, 0, 5})}).force_steps, 1);
  EXPECT_EQ(
      of({tick({0, 0, 5}, {0, 0, 0}), tick({0, 0, 5}, {0.9 * most * radius, 0, 0})}).torque_steps,
      0);
  EXPECT_EQ(
      of({tick({0, 0, 5}, {0, 0, 0}), tick({0, 0, 5}, {1.1 * most * radius, 0, 0})}).torque_steps,
      1);
}

TEST(Discontinuities, a_pop_through_is_a_depth_that_falls_while_the_force_turns_or_goes) {
  const RenderedTick deep = tick({0, 0, 5});
  EXPECT_EQ(of({deep, tick({0, 0, -4})}).pop_throughs, 1) << "out on the other side";
  EXPECT_EQ(of({deep, tick({0, 0, 0})}).pop_throughs, 1) << "the force is gone";
  EXPECT_EQ(of({deep, tick({3, 0, 2})}).pop_throughs, 0) << "another place, the same side";
  EXPECT_EQ(of({deep, tick({0, 0, -5})}).pop_throughs, 0) << "as deep as before: no way was saved";
  EXPECT_EQ(of({tick({0, 0, 0.1}), tick({0, 0, 0})}).pop_throughs, 0) << "the device left";
  EXPECT_EQ(of({tick({0, 0, 0}), tick({0, 0, 5})}).pop_throughs, 0) << "from free: no contact left";
}

TEST(Discontinuities, jumps_are_those_reported_after_the_first_tick) {
  Rendering three{tick({0, 0, 1}), tick({0, 0, 1}), tick({0, 0, 1})};
  three[0].jumped = three[2].jumped = true;
  EXPECT_EQ(of(three).jumps, 1);
}

TEST(Discontinuities, what_failed_is_not_compared) {
  Rendering three{tick({0, 0, 5}), tick({0, 0, 0}), tick({0, 0, 5})};
  three[1].failed = true;
  const Discontinuities d = of(three);
  EXPECT_EQ(d.force_steps + d.pop_throughs, 0);
  EXPECT_EQ(of({}).force_steps, 0);
}

}  // namespace
}  // namespace sonde
