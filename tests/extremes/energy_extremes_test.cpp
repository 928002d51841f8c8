// SPDX-License-Identifier: GPL-3.0-or-later
// No energy from nothing, at the extremes of stiffness, size and stride. Two references. By hand: a
// brick that is pressed into a plate, slid along and taken out gives back what was put in. And what
// follows from the metric: the last separated pose is there to be taken, so what a tick stores is
// no more than ½ k σ from the device's new pose to it.
#include <algorithm>
#include <vector>

#include "engine/haptics/loop/haptic_loop.hpp"
#include "engine/text/number_text.hpp"
#include "tests/extremes/press.hpp"
#include "tests/extremes/teleports.hpp"

namespace sonde {
namespace {

using test::brick_and_plate;
using test::flat_in_plate;

constexpr double pressed = 0.01;  // m, at size 1

Coupling springs(double k) {
  Coupling c;
  c.mode = Coupling::Mode::object;
  c.k = k;
  c.max_force = c.max_torque = 1e30;
  return c;
}

/// From above down into the plate, along it, out and back, in so many strides of each.
std::vector<Pose> closed_path(double size, int strides) {
  std::vector<Pose> out;
  const auto leg = [&](double from_deep, double to_deep, double from_x, double to_x) {
    for (int i = 1; i <= strides; ++i) {
      const double t = static_cast<double>(i) / strides;
      Pose X = flat_in_plate(from_deep + t * (to_deep - from_deep), size);
      X.p.x() += size * (from_x + t * (to_x - from_x));
      out.push_back(X);
    }
  };
  leg(-pressed, pressed, 0, 0);
  leg(pressed, pressed, 0, 0.1);
  leg(pressed, -pressed, 0.1, 0.1);
  leg(-pressed, -pressed, 0.1, 0);
  return out;
}

/// The work that the force does on the hand along the path, in parts of the most that is stored.
double net_work(const Pair& pair, double size, double k, int strides) {
  HapticLoop loop(pair, Method::pdg, springs(k));
  Pose last = flat_in_plate(-pressed, size);
  loop.reset(last, {});
  Vec3 force = Vec3::Zero();
  double work = 0, most = 0;
  for (const Pose& X : closed_path(size, strides)) {
    loop.tick(X, 1e-3, {});
    EXPECT_TRUE(loop.wrench().force.allFinite());
    most = std::max(most, loop.wrench().force.norm());
    work += 0.5 * (force + loop.wrench().force).dot(X.p - last.p);
    force = loop.wrench().force;
    last = X;
  }
  EXPECT_NEAR(most / (k * pressed * size), 1, 2e-4) << "it was pressed";
  return work / (0.5 * k * pressed * pressed * size * size);
}

void expect_no_work(const std::string& what, double size, double k, int strides) {
  const double net = net_work(brick_and_plate(size), size, k, strides);
  std::printf("  %-44s %10.2g\n", ("work of a closed path, " + what).c_str(), net);
  // Either way keeps some part of the clearance, 1e-4 of the depth, and so of the force at most.
  EXPECT_LE(std::abs(net), 2e-4 + 1e-6) << what;
}

TEST(EnergyExtremes, a_closed_path_gives_nothing_at_any_stiffness) {
  for (const double k : {1e-6, 1.0, 1e3, 1e9}) expect_no_work(number_text(k) + " N/m", 1, k, 200);
}
TEST(EnergyExtremes, nor_at_any_size) {
  for (const double size : {1e-9, 1e-3, 1e3, 1e9})
    expect_no_work("size " + number_text(size), size, 500, 200);
}
TEST(EnergyExtremes, nor_at_any_stride) {
  for (const int strides : {2, 20, 2000})
    expect_no_work(std::to_string(strides) + " ticks a stroke", 1, 500, strides);
}

/// By definition (the mean squared displacement of the probe's points), not by the engine's charts.
double sigma(const Body& probe, const Pose& O, const Pose& Q) {
  const double d = test::pose_distance(probe, O, Q);
  return d * d;
}

TEST(EnergyExtremes, a_teleport_stores_no_more_than_staying_where_it_was) {
  for (const double size : {1e-9, 1.0, 1e9}) {
    const Pair knots = test::knots(size);
    HapticLoop loop(knots, Method::pdg, springs(500));
    Pose start;
    start.p.x() = size;
    loop.reset(start, {});
    double most = 0;
    int in_contact = 0;
    for (const Pose& X : test::teleports(60, size)) {
      const Pose before = loop.separation().separated;
      loop.tick(X, 1e-3, {.work = 50'000});
      const Separation& now = loop.separation();
      ASSERT_NE(now.status, Status::failed);
      ASSERT_TRUE(loop.wrench().force.allFinite() && loop.wrench().torque.allFinite());
      const double stay = sigma(knots.probe(), X, before);
      EXPECT_LE(now.sigma, stay * (1 + 1e-9)) << size;
      most = std::max(most, now.sigma / stay);
      in_contact += now.status == Status::penetrating;
    }
    EXPECT_GT(in_contact, 10);
    std::printf("  %-44s %10.3g\n",
                ("stored of what staying would, size " + number_text(size)).c_str(), most);
  }
}

}  // namespace
}  // namespace sonde
