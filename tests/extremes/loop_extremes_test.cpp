// SPDX-License-Identifier: GPL-3.0-or-later
// The loop at the extremes: paths with jumps, unusual stiffness and rates, standstill, repeats. The
// reference is geometry by hand: a brick pressed into a plate comes straight out, and the force is
// stiffness times depth.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/haptics/loop/haptic_loop.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/extremes/press.hpp"
#include "tests/extremes/teleports.hpp"

namespace sonde {
namespace {

constexpr double deep = 0.01;  // m
/// What a descent may leave between the bodies, in parts of the depth.
constexpr double clearance = 1e-4;

/// Brings the loop from free to the pose, in so many ticks.
void press(HapticLoop& loop, double depth, int ticks, double dt, const Budget& budget = {}) {
  loop.reset(test::flat_in_plate(-0.01), {});
  for (int i = 1; i <= ticks; ++i)
    loop.tick(test::flat_in_plate(-0.01 + (depth + 0.01) * i / ticks), dt, budget);
}

Coupling without_limits() {
  Coupling c;
  c.max_force = c.max_torque = 1e12;
  return c;
}

TEST(LoopExtremes, stiffness_from_1e_minus_6_to_1e9) {
  for (const double k : {1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9}) {
    Coupling c = without_limits();
    c.mode = Coupling::Mode::object;
    c.k = k;
    HapticLoop loop(test::brick_and_plate(), Method::pdg, c);
    press(loop, deep, 20, 1e-3);
    const double off = loop.wrench().force.z() / (k * deep) - 1;
    EXPECT_GE(off, -1e-6) << k;
    EXPECT_LE(off, clearance + 1e-6) << k;
    EXPECT_LE(loop.wrench().force.head<2>().norm(), 1e-3 * k * deep) << k;
    std::printf("  stiffness %-34g %10.2g\n", k, off);
  }
}

// By hand: the separation grows at the speed v, so the force is k_t d + b_t v.
TEST(LoopExtremes, sample_times_from_50_us_to_20_ms) {
  for (const double T : {50e-6, 200e-6, 1e-3, 5e-3, 20e-3}) {
    Coupling c = without_limits();
    c.mode = Coupling::Mode::classic;
    c.k_t = 1000;
    c.b_t = 5;
    HapticLoop loop(test::brick_and_plate(), Method::pdg, c);
    constexpr int ticks = 40;
    press(loop, deep, ticks, T);
    const double speed = 2 * deep / (ticks * T);
    const double wanted = c.k_t * deep + c.b_t * speed;
    const double off = loop.wrench().force.z() / wanted - 1;
    EXPECT_LE(std::abs(off), 2 * clearance) << T;
    std::printf("  sample time %-32g %10.2g\n", T, off);
  }
}

/// An hour at 1 kHz, or the part of it. The reference is the first tick.
void stand_still(int ticks) {
  Coupling c = without_limits();
  c.mode = Coupling::Mode::object;
  c.k = 1000;
  HapticLoop loop(test::brick_and_plate(), Method::pdg, c);
  press(loop, deep, 20, 1e-3);
  loop.tick(test::flat_in_plate(deep), 1e-3, {});
  const Separation first = loop.separation();
  const Wrench wrench = loop.wrench();
  for (int i = 0; i < ticks; ++i) loop.tick(test::flat_in_plate(deep), 1e-3, {});
  const Separation& last = loop.separation();
  EXPECT_EQ(last.separated.p, first.separated.p);
  EXPECT_EQ(last.separated.q.coeffs(), first.separated.q.coeffs());
  EXPECT_EQ(loop.wrench().force, wrench.force);
  EXPECT_EQ(loop.wrench().torque, wrench.torque);
  EXPECT_NEAR(last.depth, deep, clearance * deep);
}
TEST(LoopExtremes, a_minute_of_standstill_moves_nothing) { stand_still(60'000); }
TEST(LoopExtremes, Full_an_hour_of_standstill_moves_nothing) { stand_still(3'600'000); }

/// Reference: the exact test, and what follows from the metric: the last separated pose is there to
// stay at, so the depth rises by no more than the object norm of the device's own motion.
void teleport(int count, std::int64_t work) {
  const Pair pair = test::knots();
  CoherentSolver solver(pair);
  const std::vector<Pose> path = test::teleports(count);
  Pose start;
  start.p.x() = 1;
  ASSERT_EQ(solver.reset(start).status, Status::separated);
  int in_contact = 0;
  double before = 0;
  Pose last = start;
  for (const Pose& at : path) {
    const Separation& s = solver.tick(at, {.work = work});
    ASSERT_NE(s.status, Status::failed);
    ASSERT_TRUE(std::isfinite(s.depth));
    ASSERT_FALSE(overlap(pair.probe(), pair.fixed(), Transform(s.separated), Doubt::exact));
    const Chart chart(pair.probe().mass, last);
    ASSERT_LE(s.depth, (before + chart.coordinates(at).norm()) * (1 + 1e-9)) << work;
    in_contact += s.status == Status::penetrating;
    before = s.depth;
    last = at;
  }
  EXPECT_GT(in_contact, 5) << work;
}
TEST(LoopExtremes, teleports_leave_the_probe_free_with_any_budget) {
  for (const std::int64_t work : {500, 5000, 50'000}) teleport(40, work);
}
TEST(LoopExtremes, teleports_leave_the_probe_free_without_a_budget) { teleport(40, 0); }

/// Without a budget a teleport takes what it is given for itself, which is counted: reference, the
/// same with a budget of so much.
TEST(LoopExtremes, a_teleport_without_a_budget_is_limited_by_counted_work) {
  const Pair pair = test::knots();
  Pose start;
  start.p.x() = 1;
  CoherentSolver one(pair), two(pair);
  one.reset(start);
  two.reset(start);
  int cut_short = 0;
  for (const Pose& at : test::teleports(12)) {
    const Separation& a = one.tick(at);
    const Separation& b = two.tick(at, {.work = 3'000'000});
    ASSERT_EQ(a.depth, b.depth);
    ASSERT_EQ(a.separated.p, b.separated.p);
    cut_short += !a.converged;
  }
  EXPECT_GT(cut_short, 0) << "else the test shows nothing";
}

TEST(LoopExtremes, the_same_path_again_gives_the_same_bits) {
  const Pair pair = test::knots();
  Pose start;
  start.p.x() = 1;
  CoherentSolver one(pair), two(pair);
  one.reset(start);
  two.reset(start);
  for (const Pose& at : test::teleports(12)) {
    const Separation& a = one.tick(at, {.work = 50'000});
    const Separation& b = two.tick(at, {.work = 50'000});
    ASSERT_EQ(a.depth, b.depth);
    ASSERT_EQ(a.separated.p, b.separated.p);
    ASSERT_EQ(a.separated.q.coeffs(), b.separated.q.coeffs());
  }
}

// A row that is repeated is no motion: the depth does not rise.
TEST(LoopExtremes, repeated_rows_never_go_deeper) {
  const Pair pair = test::knots();
  Pose start;
  start.p.x() = 1;
  CoherentSolver solver(pair);
  solver.reset(start);
  for (const Pose& at : test::teleports(12)) {
    double last = solver.tick(at, {.work = 50'000}).depth;
    for (int again = 0; again < 5; ++again) {
      const double now = solver.tick(at, {.work = 50'000}).depth;
      ASSERT_LE(now, last * (1 + 1e-12));
      last = now;
    }
  }
}

}  // namespace
}  // namespace sonde
