// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/workspace_map.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace sonde {
namespace {

constexpr double pi = std::numbers::pi;

Quat turn(double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis)); }

struct WorkspaceMapTest : testing::Test {
  std::mt19937 random{5};
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  Vec3 vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  Pose pose() {
    return {Quat(Eigen::AngleAxisd(uniform(0, 3), vector(1).normalized())), vector(0.1)};
  }
};

TEST_F(WorkspaceMapTest, as_it_comes_the_probe_does_what_the_handle_does) {
  WorkspaceMap map;
  const Pose X_BH0 = pose(), X_FC0 = pose();
  map.anchor(X_BH0, X_FC0);
  for (int i = 0; i < 100; ++i) {
    const Pose X_BH{turn(uniform(0, 1.5), vector(1).normalized()) * X_BH0.q, X_BH0.p + vector(0.1)};
    const Pose X_FC = map.follow(X_BH);
    EXPECT_LT((X_FC.p - X_FC0.p - (X_BH.p - X_BH0.p)).norm(), 1e-15);
    EXPECT_LT(X_FC.q.angularDistance(X_BH.q * X_BH0.q.conjugate() * X_FC0.q), 1e-7);
  }
}

TEST_F(WorkspaceMapTest, axes_are_scaled_swapped_turned_round_and_seen_from_the_base) {
  AxisMap axes;
  axes.axes[0] = {.source = 1, .inverted = true, .gain = 2};
  axes.axes[1] = {.source = 0};
  axes.axes[2] = {.source = 5};  // a translation is no rotation: stands still
  axes.axes[3] = {.source = 4};
  axes.axes[4] = {.source = 3, .gain = 0.5};
  WorkspaceMap map;
  map.configure(axes, 10, turn(pi / 2, Vec3::UnitZ()));
  map.anchor({}, {});
  // (1, 2, 3) mm in the base: (-2·2, 1, 0)·10 there, and a quarter turn about z of that.
  EXPECT_LT(
      (map.follow({Quat::Identity(), Vec3(1, 2, 3) * 1e-3}).p - Vec3(-10, -40, 0) * 1e-3).norm(),
      1e-15);
  // About the handle's x by 0.4: about the base's y by 0.2, which is the scene's -x.
  const Quat q = map.follow({turn(0.4, Vec3::UnitX()), Vec3::Zero()}).q;
  EXPECT_LT(q.angularDistance(turn(-0.2, Vec3::UnitX())), 1e-7);
}

TEST_F(WorkspaceMapTest, with_gains_of_one_many_turns_are_as_exact_as_one) {
  WorkspaceMap map;
  map.anchor({}, {});
  Pose X_FC;
  for (int i = 0; i <= 1000; ++i) X_FC = map.follow({turn(0.02 * i, Vec3::UnitY()), Vec3::Zero()});
  EXPECT_LT((X_FC.q.toRotationMatrix() - turn(20, Vec3::UnitY()).toRotationMatrix()).norm(), 1e-12);
}

/// The reference is the step of the turn: what is smooth changes by no more than some times that.
TEST_F(WorkspaceMapTest, neither_the_probe_nor_the_torque_jumps_over_many_turns) {
  AxisMap axes;
  for (std::size_t a = 3; a < 6; ++a) axes.axes[a].gain = 2;
  axes.axes[4].inverted = true;
  WorkspaceMap map;
  map.configure(axes, 1, turn(0.4, Vec3(1, 0, 1).normalized()));
  map.anchor({}, {});
  constexpr double step = 1e-3;
  const Wrench wrench{.torque = Vec3(0.1, -0.2, 0.15)};
  Quat handle = Quat::Identity();
  Quat probe = map.follow({handle, Vec3::Zero()}).q;
  Vec3 felt = map.on_handle(wrench).torque;
  for (int i = 0; i < 12'000; ++i) {
    // About an axis that sways.
    const Vec3 axis = Vec3(std::sin(1e-3 * i), 1, std::cos(7e-4 * i)).normalized();
    handle = (turn(step, axis) * handle).normalized();
    const Quat now = map.follow({handle, Vec3::Zero()}).q;
    const Vec3 torque = map.on_handle(wrench).torque;
    // A gain of 2, and what the Jacobians of a quarter of a turn make of it.
    ASSERT_LT(now.angularDistance(probe), 8 * step) << i;
    ASSERT_LT((torque - felt).norm(), 8 * step * wrench.torque.norm()) << i;
    probe = now;
    felt = torque;
  }
}

/// The velocities of a frame by central differences of its pose, in the frame it is seen from.
struct Twist {
  Vec3 v, w;
};
Twist twist(const Pose& before, const Pose& after, double dt) {
  const Eigen::AngleAxisd change(after.q * before.q.conjugate());
  return {(after.p - before.p) / dt, change.angle() * change.axis() / dt};
}

/// The reference is the definition of power, force by velocity, at both ends.
TEST_F(WorkspaceMapTest, the_hand_does_the_work_that_is_done_on_the_probe) {
  for (int i = 0; i < 200; ++i) {
    AxisMap axes;
    for (std::size_t a = 0; a < 6; ++a)
      axes.axes[a] = {.source = static_cast<int>(uniform(0, 6)),
                      .inverted = uniform(0, 1) > 0.5,
                      .gain = uniform(0, 3)};
    WorkspaceMap map;
    map.configure(axes, uniform(0.1, 10), pose().q);
    const Pose X_BH0 = pose();
    map.anchor(X_BH0, pose());
    const Vec3 velocity = vector(1), spin = vector(1);
    const Pose start{turn(uniform(0, 1.4), vector(1).normalized()) * X_BH0.q, pose().p};
    const auto handle = [&](double t) -> Pose {
      return {turn(t * spin.norm(), spin.normalized()) * start.q, start.p + t * velocity};
    };
    constexpr double h = 1e-5;
    const Pose before = map.follow(handle(-h)), after = map.follow(handle(h));
    const Twist probe = twist(before, after, 2 * h);
    map.follow(handle(0));
    const Wrench wrench{.force = vector(10), .torque = vector(1)};
    const DeviceWrench felt = map.on_handle(wrench);
    const double on_probe = wrench.force.dot(probe.v) + wrench.torque.dot(probe.w);
    const double by_hand = felt.force.dot(velocity) + felt.torque.dot(spin);
    EXPECT_NEAR(by_hand, on_probe, 1e-7 * (1 + std::abs(on_probe)));
  }
}

TEST_F(WorkspaceMapTest, a_scaling_of_s_feels_s_squared_as_stiff) {
  constexpr double s = 3, k = 500;
  WorkspaceMap map;
  map.configure({}, s, Quat::Identity());
  map.anchor({}, {});
  const double way = 0.002;
  const Vec3 at = map.follow({Quat::Identity(), Vec3(way, 0, 0)}).p;
  const DeviceWrench felt = map.on_handle({.force = -k * at});
  EXPECT_NEAR(-felt.force.x() / way, s * s * k, 1e-9);
}

}  // namespace
}  // namespace sonde
