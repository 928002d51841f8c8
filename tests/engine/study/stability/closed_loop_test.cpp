// SPDX-License-Identifier: GPL-3.0-or-later
// References: the simulated device and the haptic loop, run by hand, and the balance of forces.
#include "engine/study/stability/closed_loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/geometry/rotation.hpp"
#include "engine/platform/processor_time.hpp"
#include "engine/scene/poses.hpp"
#include "engine/scene/scene.hpp"
#include "engine/settings/device_profile.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

ClosedLoopSetup cube_over_block() {
  // Off its own centre, so that handle and mesh frame are not the same.
  PolygonSoup cube = test::box({0.05, 0.05, 0.05});
  for (Vec3& x : cube.points) x += Vec3(0.01, 0.02, 0.03);
  ClosedLoopSetup out{.pair = {test::body(cube), test::body(test::box({1, 1, 0.2}))}};
  out.coupling.k = 400;
  out.device.translation.friction = 0.05;
  out.device.translation.resolution = 1e-5;
  out.device.rotation.resolution = 1e-4;
  out.device.delay = 1.5e-3;
  return out;
}

const Pose loop_start{Quat::Identity(), {-0.01, -0.02, 0.1 + 0.025 - 0.03 + 0.002}};

TEST(ClosedLoop, is_the_device_and_the_loop_tick_by_tick) {
  const ClosedLoopSetup s = cube_over_block();
  ClosedLoop loop(s);
  loop.reset(loop_start);

  HapticLoop haptic(s.pair, s.method, s.coupling);
  haptic.reset(loop_start, {});
  const Pose X_MD{Quat::Identity(), s.pair.probe().mass.com};
  SimulatedDevice device(s.device, s.sample_time, loop_start * X_MD);
  Wrench push;
  push.force = {0.2, 0, -2};
  for (int i = 0; i < 400; ++i) {
    loop.step(loop_start, push);
    haptic.tick(device.measured() * inverse(X_MD), s.sample_time, {});
    device.step(haptic.wrench(), loop_start * X_MD, push);
    ASSERT_NEAR((loop.X_FM().p - (device.state().X_WD * inverse(X_MD)).p).norm(), 0, 1e-12) << i;
  }
  EXPECT_EQ(loop.haptic_loop().separation().status, Status::penetrating);
}

TEST(ClosedLoop, at_rest_the_motors_balance_the_hand) {
  ClosedLoopSetup s = cube_over_block();
  s.device.translation.friction = 0;
  s.device.translation.resolution = s.device.rotation.resolution = 0;
  ClosedLoop loop(s);
  loop.reset(loop_start);
  Wrench push;
  push.force = {0, 0, -2};
  for (int i = 0; i < 3000; ++i) loop.step(loop_start, push);
  const double hand = -2 + 300 * (loop_start.p.z() - loop.X_FM().p.z());
  EXPECT_NEAR(loop.device().motors().force.z(), -hand, 1e-4);
  const Wrench hooke =
      spring_wrench(s.pair.probe().mass, loop.haptic_loop().separation(), s.coupling);
  EXPECT_NEAR(hooke.force.z(), 400 * loop.haptic_loop().separation().depth, 1e-6);
  EXPECT_LT(kinetic_energy(s.device, loop.device().state()), 1e-10);
}

/// J of a push's torque on a handle that is turned round a cone of rotation vectors, `apart` from
/// the target and back to where it began.
double work_of_whirl(const Wrench& push, double apart, bool as_turned) {
  constexpr int steps = 20000;
  double work = 0;
  const auto at = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / steps;
    return Vec3(0.3 + apart * std::cos(angle), apart * std::sin(angle), 0.1);
  };
  const auto rotation = [](const Vec3& phi) {
    return Quat(Eigen::AngleAxisd(phi.norm(), phi.normalized()));
  };
  for (int i = 0; i < steps; ++i) {
    const Vec3 turn = rotation_vector(rotation(at(i + 1)) * rotation(at(i)).conjugate());
    const Vec3 middle = (at(i) + at(i + 1)) / 2;
    work += (as_turned ? push_as_turned(push, middle) : push).torque.dot(turn);
  }
  return work;
}

// Reference: the work along a closed path of rotations, summed up; and the potential −τ·φ. A torque
// of fixed direction gives ½ τ·∮φ×dφ, to second order, which no friction ends.
TEST(ClosedLoop, a_hands_push_gives_nothing_to_what_whirls) {
  Wrench push;
  push.force = {0, 0, -3};
  push.torque = {0.02, -0.01, 0.1};
  EXPECT_NEAR(work_of_whirl(push, 0.2, false), 0.1 * std::numbers::pi * 0.2 * 0.2, 1e-3);
  EXPECT_NEAR(work_of_whirl(push, 0.2, true), 0, 1e-9);
  EXPECT_NEAR(work_of_whirl(push, 1.5, true), 0, 1e-7);
  EXPECT_EQ(push_as_turned(push, Vec3::Zero()).torque, push.torque);
  EXPECT_EQ(push_as_turned(push, {1, 2, 0.5}).force, push.force);
  // Along its own axis a torque gives what it takes: τ·Δφ.
  EXPECT_LT((push_as_turned(push, 4 * push.torque).torque - push.torque).norm(), 1e-12);
}

TEST(ClosedLoop, same_input_same_bits_and_no_allocation_in_a_step) {
  const auto run = [] {
    ClosedLoop loop(cube_over_block());
    loop.reset(loop_start);
    Wrench push;
    push.force = {0.3, 0.1, -3};
    push.torque = {0, 0.01, 0};
    test::AllocationCounter counter;
    for (int i = 0; i < 500; ++i) loop.step(loop_start, push);
    counter.stop();
    EXPECT_EQ(counter.allocations(), 0u);
    return loop.X_FM();
  };
  const Pose a = run(), b = run();
  EXPECT_EQ(a.p, b.p);
  EXPECT_EQ(a.q.coeffs(), b.q.coeffs());
}

TEST(ClosedLoop, Full_along_the_spoons_path_every_tick_has_an_answer) {
  const Scene scene = read_scene(SONDE_RESOURCES "/scenes/spoon-in-cup.sonde.json");
  ClosedLoopSetup setup{.pair = {load(scene.probe, scene.unit), load(scene.fixed, scene.unit)}};
  setup.coupling = scene.coupling;
  setup.device = simulated(read_device_profile(SONDE_RESOURCES "/devices/sigma.7.json"));
  setup.budget.steps = 60;
  const std::vector<TimedPose> path = read_trajectory(*scene.trajectory);
  ClosedLoop loop(setup);
  loop.reset(path.front().pose);
  const double begin = processor_time_us();
  int touching = 0;
  for (const TimedPose& at : path) {
    loop.step(at.pose);
    ASSERT_NE(loop.haptic_loop().separation().status, Status::failed) << at.t;
    touching += loop.haptic_loop().separation().status == Status::penetrating;
  }
  EXPECT_GT(touching, 3000);
  const double simulated_time = double(path.size()) * setup.sample_time;
  const double took = 1e-6 * (processor_time_us() - begin);  // s
  RecordProperty("times_real_time", std::to_string(simulated_time / took));
}

}  // namespace
}  // namespace sonde
