// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/haptic_loop.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "tests/engine/haptics/tick_time.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/contact_path.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::contact_pairs;
using test::contact_path;
using test::ContactPair;
using test::dt;

TEST(HapticLoop, a_tick_neither_allocates_nor_frees_on_a_path_through_contact) {
  for (const Coupling::Mode mode : {Coupling::Mode::object, Coupling::Mode::classic})
    for (const Method method : {Method::pdg, Method::pdt})
      for (const ContactPair& pair : contact_pairs()) {
        Coupling coupling;
        coupling.mode = mode;
        coupling.b_t = coupling.b_r = 0.01;
        HapticLoop loop({pair.probe, pair.fixed}, method, coupling);
        loop.reset(contact_path(pair, 0), {});
        constexpr int ticks = 300;
        int in_contact = 0;
        test::AllocationCounter counter;
        for (int i = 0; i <= ticks; ++i) {
          loop.tick(contact_path(pair, double(i) / ticks), dt, {});
          in_contact += loop.separation().status == Status::penetrating;
        }
        counter.stop();
        EXPECT_EQ(counter.allocations(), 0u) << pair.name;
        EXPECT_EQ(counter.frees(), 0u) << pair.name;
        EXPECT_GT(in_contact, ticks / 10) << pair.name;  // or nothing was tested
        EXPECT_LT(in_contact, ticks) << pair.name;
      }
}

TEST(HapticLoop, the_wrench_is_the_coupling_of_the_separation_within_the_limits) {
  for (const ContactPair& pair : contact_pairs()) {
    Coupling coupling;
    coupling.k = 2000;
    coupling.max_force = 3;
    coupling.max_torque = 0.02;
    HapticLoop loop({pair.probe, pair.fixed}, Method::pdg, coupling);
    loop.reset(contact_path(pair, 0), {});
    int saturated = 0;
    for (int i = 0; i <= 300; ++i) {
      loop.tick(contact_path(pair, i / 300.0), dt, {});
      const Separation& s = loop.separation();
      ASSERT_NE(s.status, Status::failed) << pair.name << ": " << s.reason;
      const Wrench want =
          s.status == Status::penetrating
              ? limit(object_norm_wrench(pair.probe->mass, s.device, s.separated, coupling.k), 3,
                      0.02)
              : Wrench{};
      EXPECT_EQ(loop.wrench().force, want.force);
      EXPECT_EQ(loop.wrench().torque, want.torque);
      EXPECT_LE(loop.wrench().force.norm(), 3 * (1 + 1e-15));
      saturated += loop.wrench().saturated;
    }
    EXPECT_GT(saturated, 0) << pair.name;
  }
}

/// The separation of a tick as the classic coupling sees it.
SeparationMotion motion(const ContactPair& pair, const Separation& s) {
  if (s.status != Status::penetrating) return {};
  return separation_motion(pair.probe->mass, s.device, s.separated);
}

Coupling damped_in_both() {
  Coupling c;
  c.mode = Coupling::Mode::classic;
  c.k_t = 300;
  c.k_r = 0.5;
  c.b_t = 2;
  c.b_r = 0.002;
  c.max_force = c.max_torque = 1e9;
  return c;
}

TEST(HapticLoop, classic_damping_acts_on_the_backward_difference_of_the_separation) {
  for (const ContactPair& pair : contact_pairs()) {
    const Coupling c = damped_in_both();
    HapticLoop loop({pair.probe, pair.fixed}, Method::pdg, c);
    loop.reset(contact_path(pair, 0), {});
    SeparationMotion before;
    int damped_ticks = 0;
    for (int i = 1; i <= 300; ++i) {
      loop.tick(contact_path(pair, i / 300.0), dt, {});
      const SeparationMotion now = motion(pair, loop.separation());
      // After the first tick the wrench follows from the poses alone; out of contact both are zero.
      if (i > 1 && !loop.separation().jumped) {
        const Vec3 force = c.k_t * now.t + c.b_t / dt * (now.t - before.t);
        const Vec3 torque = c.k_r * now.theta + c.b_r / dt * (now.theta - before.theta);
        const bool contact = loop.separation().status == Status::penetrating;
        const Wrench got = loop.wrench();
        EXPECT_LT((got.force - (contact ? force : Vec3::Zero())).norm(),
                  1e-12 * (1 + force.norm()));
        EXPECT_LT((got.torque - (contact ? torque : Vec3::Zero())).norm(),
                  1e-12 * (1 + torque.norm()));
        damped_ticks += contact && (now.t - before.t).norm() > 0;
      }
      before = now;
    }
    EXPECT_GT(damped_ticks, 30) << pair.name;
  }
}

/// A box that slides over a block: at rest in it, out of it, in it again.
Pose sliding(double depth, double x = 0) {
  return {Quat::Identity(), Vec3(x, 0, 0.05 + 0.025 - depth)};
}

TEST(HapticLoop, nothing_is_damped_out_of_contact) {
  const ContactPair pair = contact_pairs()[0];
  Coupling c = damped_in_both();
  c.b_t = 1e6;
  HapticLoop loop({pair.probe, pair.fixed}, Method::pdg, c);
  loop.reset(sliding(0.003), {});
  loop.tick(sliding(0.003), dt, {});
  ASSERT_EQ(loop.separation().status, Status::penetrating);
  for (int i = 1; i < 20; ++i) {
    loop.tick(sliding(-0.002 * i, 0.005 * i), dt, {});
    ASSERT_EQ(loop.separation().status, Status::separated);
    EXPECT_EQ(loop.wrench().force, Vec3::Zero());
    EXPECT_EQ(loop.wrench().torque, Vec3::Zero());
  }
}

TEST(HapticLoop, a_new_contact_knows_nothing_of_the_one_before) {
  const ContactPair pair = contact_pairs()[0];
  const Coupling c = damped_in_both();
  HapticLoop loop({pair.probe, pair.fixed}, Method::pdg, c);
  loop.reset(sliding(-0.001), {});
  for (const double depth : {0.001, 0.003, -0.001, 0.0015}) loop.tick(sliding(depth), dt, {});
  const Vec3 t = motion(pair, loop.separation()).t;
  ASSERT_NEAR(t.z(), 0.0015, 1e-6);
  EXPECT_LT((loop.wrench().force - (c.k_t + c.b_t / dt) * t).norm(), 1e-12);
}

TEST(HapticLoop, the_first_tick_after_a_reset_or_without_a_time_step_is_not_damped) {
  const ContactPair pair = contact_pairs()[0];
  const Coupling c = damped_in_both();
  HapticLoop loop({pair.probe, pair.fixed}, Method::pdg, c);
  const auto is_spring_alone = [&] {
    const SeparationMotion now = motion(pair, loop.separation());
    EXPECT_GT(now.t.norm(), 1e-3);
    EXPECT_LT((loop.wrench().force - c.k_t * now.t).norm(), 1e-12);
    EXPECT_LT((loop.wrench().torque - c.k_r * now.theta).norm(), 1e-12);
  };
  loop.reset(sliding(0.002), {});
  is_spring_alone();
  loop.tick(sliding(0.003), dt, {});
  is_spring_alone();
  loop.tick(sliding(0.002), 0, {});
  is_spring_alone();
  loop.tick(sliding(0.003), std::numeric_limits<double>::quiet_NaN(), {});
  is_spring_alone();
  loop.tick(sliding(0.002), dt, {});
  EXPECT_GT((loop.wrench().force - c.k_t * motion(pair, loop.separation()).t).norm(), 0.1);
}

TEST(HapticLoop, a_pose_that_is_no_pose_gives_no_wrench_and_does_no_harm) {
  const ContactPair pair = contact_pairs()[0];
  const Coupling c = damped_in_both();
  HapticLoop loop({pair.probe, pair.fixed}, Method::pdg, c);
  loop.reset(sliding(0.002), {});
  Pose bad = sliding(0.002);
  bad.p.y() = std::numeric_limits<double>::quiet_NaN();
  loop.tick(sliding(0.002), dt, {});
  for (int i = 0; i < 2; ++i) {
    loop.tick(bad, dt, {});
    EXPECT_EQ(loop.separation().status, Status::failed);
    EXPECT_STRNE(loop.separation().reason, "");
    EXPECT_EQ(loop.wrench().force, Vec3::Zero());
    EXPECT_EQ(loop.wrench().torque, Vec3::Zero());
  }
  loop.tick(sliding(0.003), dt, {});
  ASSERT_EQ(loop.separation().status, Status::penetrating);
  EXPECT_FALSE(loop.separation().jumped);
  EXPECT_NEAR(loop.wrench().force.z(), c.k_t * 0.003, 1e-3);  // spring alone: no rate over a gap
}

TEST(HapticLoop, before_a_reset_there_is_no_wrench) {
  const ContactPair pair = contact_pairs()[0];
  HapticLoop loop({pair.probe, pair.fixed}, Method::pdg, {});
  loop.tick(sliding(0.002), dt, {});
  EXPECT_EQ(loop.separation().status, Status::failed);
  EXPECT_EQ(loop.wrench().force, Vec3::Zero());
}

TEST(HapticLoop, a_coupling_change_acts_on_the_next_tick) {
  const ContactPair pair = contact_pairs()[0];
  Coupling c;
  c.k = 100;
  HapticLoop loop({pair.probe, pair.fixed}, Method::pdg, c);
  loop.reset(sliding(0.002), {});
  loop.tick(sliding(0.002), dt, {});
  const Vec3 soft = loop.wrench().force;
  c.k = 300;
  loop.set_coupling(c);
  EXPECT_EQ(loop.wrench().force, soft);
  loop.tick(sliding(0.002), dt, {});
  EXPECT_LT((loop.wrench().force - 3 * soft).norm(), 3e-4 * soft.norm());
  EXPECT_NEAR(soft.z(), 0.2, 1e-3);
}

// A small ball held above a thin plate, whose hand goes round the plate's edge: the separated pose
// falls off the edge, far faster than the hand moves.
TEST(HapticLoop, a_jump_is_not_damped) {
  const ContactPair pair{"ball and plate", test::body(test::sphere(0.005, 6, 8)),
                         test::body(test::box({0.2, 0.2, 0.002})), 0};
  const Coupling c = damped_in_both();
  HapticLoop loop({pair.probe, pair.fixed}, Method::pdg, c);
  loop.reset({Quat::Identity(), {0, 0, 0.02}}, {});
  int jumps_in_contact = 0;
  Vec3 before = Vec3::Zero();
  const auto tick = [&](const Vec3& p) {
    loop.tick({Quat::Identity(), p}, dt, {});
    const Separation& s = loop.separation();
    const Vec3 now = motion(pair, s).t;
    const double fall = before.norm() - now.norm();
    EXPECT_TRUE(s.jumped || fall < 1e-3) << "a fall of " << fall << " m at " << p.transpose();
    if (s.jumped && s.status == Status::penetrating) {
      EXPECT_LT((loop.wrench().force - c.k_t * now).norm(), 1e-9);
      ++jumps_in_contact;
    }
    before = now;
  };
  for (int i = 0; i <= 230; ++i) tick({0, 0, 0.02 - 1e-4 * i});  // into the plate
  EXPECT_NEAR(before.z(), 0.009, 5e-4);                          // and held on top of it
  for (int i = 0; i <= 400; ++i) tick({3e-4 * i, 0, -0.003});    // out past its edge
  EXPECT_EQ(loop.separation().status, Status::separated);
  EXPECT_GE(jumps_in_contact, 1);
}

}  // namespace
}  // namespace sonde
