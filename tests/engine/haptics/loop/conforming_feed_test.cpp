// SPDX-License-Identifier: GPL-3.0-or-later
// The servo's rows where faces lie on each other. Reference: the coherent solver, run in step on
// the same path; how right that is, conforming_test.cpp and peg_in_hole_test.cpp say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/haptics/loop/contact_feed.hpp"
#include "tests/support/conforming_scene.hpp"

namespace sonde {
namespace {

using test::BodyPairCut;
using test::Cutting;

constexpr std::size_t oldest = 5;  ///< ticks

struct FeedFault {
  double force = 0, torque = 0;  ///< the largest, as a share of the largest in step
  std::size_t at = 0;            ///< tick of the largest fault of the force
  int ticks = 0;                 ///< in contact, and compared
};

/// Rows of 1 to `oldest` ticks ago, solved at the device pose of now, beside the solver in step.
FeedFault fault_of_old_rows(const BodyPairCut& bodies, const std::vector<Pose>& path) {
  const MassProperties& mass = bodies.probe->mass;
  ContactFeed feed({bodies.probe, bodies.fixed}, Method::pdg);
  CoherentSolver solver({bodies.probe, bodies.fixed});
  std::vector<LocalContacts> rows;
  FeedFault out;
  double largest_force = 0, largest_torque = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Separation& s = i == 0 ? solver.reset(path[i]) : solver.tick(path[i]);
    const Wrench want = object_norm_wrench(mass, s.device, s.separated, test::felt_stiffness);
    largest_force = std::max(largest_force, want.force.norm());
    largest_torque = std::max(largest_torque, want.torque.norm());
    rows.push_back(i == 0 ? feed.reset(path[i], {})
                          : feed.refresh(path[i], i, 1e-3 * double(i), {}));
    if (rows.size() > oldest + 1) rows.erase(rows.begin());
    for (std::size_t r = 0; r + 1 < rows.size(); ++r) {
      // Where the separated pose jumped since, force is not continuous, in step or not.
      if (rows[r].jumps != rows.back().jumps) continue;
      const Separation got = separate_locally(mass, Method::pdg, rows[r], path[i]).separation;
      const Wrench w = object_norm_wrench(mass, path[i], got.separated, test::felt_stiffness);
      const double fault = (w.force - want.force).norm();
      if (!(fault <= out.force)) out.force = fault, out.at = i;
      out.torque = std::max(out.torque, (w.torque - want.torque).norm());
      out.ticks += s.status == Status::penetrating;
    }
  }
  out.force /= largest_force;
  // Where faces lie flat there is no torque: then beside the force at the radius of gyration.
  out.torque /= std::max(largest_torque, largest_force * std::sqrt(mass.inertia.maxCoeff()));
  return out;
}

constexpr double asked = 0.02;  ///< of the largest force and torque

void expect_small_fault(const std::string& name, const BodyPairCut& bodies,
                        const std::vector<Pose>& path) {
  const FeedFault fault = fault_of_old_rows(bodies, path);
  std::printf("  %s: force %.2g, torque %.2g of the largest\n", name.c_str(), fault.force,
              fault.torque);
  EXPECT_GT(fault.ticks, int(path.size())) << name << ": or nothing was tested";
  EXPECT_LE(fault.force, asked) << name << ": worst at tick " << fault.at;
  EXPECT_LE(fault.torque, asked) << name;
}

std::string named(const std::string& what, int n) { return what + ", n = " + std::to_string(n); }

/// At 1 kHz down at 0.1 m/s; about the tilts that a hand makes where a face should carry it.
void expect_small_fault_of_block(const std::vector<int>& cuts) {
  const auto scene = test::block_on_slab();
  for (const int n : cuts) {
    const BodyPairCut bodies = cut_bodies(scene, {n});
    expect_small_fault(named("block pressed and slid", n), bodies, scene.path);
    expect_small_fault(named("block pressed, slid and tilted", n), bodies, test::block_loop(1000));
  }
}

/// The hand pushes aside and askew by far more than the clearance, at 0.025 m/s along the axis.
/// Guided at the mouth: past its edge a plane that was the wall is none, and no old row can say so.
void expect_small_fault_of_peg(const std::vector<int>& cuts) {
  const auto scene =
      test::peg_in_hole(1e-4, {.shift = 6e-4, .tilt = 0.015, .step = 2.5e-5, .guided = 0.004});
  for (const int n : cuts)
    expect_small_fault(named("peg, clearance 1 %", n), cut_bodies(scene, {n}), scene.path);
}

TEST(ConformingFeed, coarse_block_is_held_by_rows_five_ticks_old) {
  expect_small_fault_of_block({1});
}
TEST(ConformingFeed, coarse_peg_is_held_by_rows_five_ticks_old) { expect_small_fault_of_peg({1}); }
TEST(ConformingFeed, fine_block_is_held_by_rows_five_ticks_old) {
  expect_small_fault_of_block({24});
}
TEST(ConformingFeed, fine_peg_is_held_by_rows_five_ticks_old) { expect_small_fault_of_peg({16}); }
TEST(ConformingFeed, Full_block_is_held_by_rows_five_ticks_old) {
  expect_small_fault_of_block({3, 8, 16, 31, 40});
}
TEST(ConformingFeed, Full_peg_is_held_by_rows_five_ticks_old) {
  expect_small_fault_of_peg({4, 8, 24, 32});
}

}  // namespace
}  // namespace sonde
