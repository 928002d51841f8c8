// SPDX-License-Identifier: GPL-3.0-or-later
// The energy test of closed slow loops (energy_test.cpp) where faces lie on each other, finely cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "tests/support/conforming_scene.hpp"

namespace sonde {
namespace {

using test::ConformingScene;
using test::Cutting;

/// Reference: conservation. The work on the hand, by the trapezoidal rule, is what the stored
/// energy ½kσ loses. What they do not account for is a loss at a reported jump, where a place was
/// let go by less than counts as one (the next one was nearer than it already, seen from where the
/// device was then; the hand gets nothing by it), or wrong.
void expect_no_work(const ConformingScene& scene, const std::vector<Pose>& loop,
                    const Cutting& cutting) {
  const std::string what = scene.name + ", n = " + std::to_string(cutting.n);
  const auto bodies = cut_bodies(scene, cutting);
  const auto felt = follow(bodies, loop);
  double work = 0, lost = 0, largest = 0;
  double let_go_of = 0;
  int open = 0, jumps = 0;
  for (std::size_t i = 1; i < felt.size(); ++i) {
    const auto &a = felt[i - 1], &b = felt[i];
    ASSERT_NE(b.status, Status::failed) << what;
    const SeparationMotion step = separation_motion(bodies.probe->mass, loop[i - 1], loop[i]);
    const double done =
        0.5 * (a.force + b.force).dot(step.t) + 0.5 * (a.torque + b.torque).dot(step.theta);
    const double before = test::felt_stiffness / 2 * a.depth * a.depth,
                 now = test::felt_stiffness / 2 * b.depth * b.depth;
    work += done;
    const double had_been = Chart(bodies.probe->mass, loop[i - 1]).coordinates(b.separated).norm();
    const bool let_go =
        had_been < a.depth - 2 * allowed_clearance(bodies.probe->mass.radius, a.depth);
    if (!b.jumped && !let_go) lost += before - now - done;
    let_go_of += let_go && !b.jumped ? before - now - done : 0;
    largest = std::max(largest, now);
    open += !b.converged;
    jumps += b.jumped;
  }
  EXPECT_EQ(felt.front().depth, 0) << what;
  EXPECT_EQ(felt.back().depth, 0) << what << ": back where it began";
  ASSERT_GT(largest, 1e-6) << what << ": or nothing was tested";
  EXPECT_EQ(open, 0) << what << ": ticks that have not converged";
  EXPECT_LE(work, 1e-3 * largest) << what;
  EXPECT_LE(std::abs(lost), 1e-3 * largest) << what;
  // Energy is lost there, none is won, and it is little.
  EXPECT_GE(let_go_of, 0) << what;
  EXPECT_LE(let_go_of, 5e-3 * largest) << what;
  if (jumps == 0) {
    EXPECT_GE(work + let_go_of, -1e-3 * largest) << what;
  }
}

constexpr int ticks = 4000;

void expect_no_work_of_block(const std::vector<int>& cuts) {
  for (const int n : cuts) expect_no_work(test::block_on_slab(), test::block_loop(ticks), {n});
}
void cylinder(const std::vector<int>& cuts) {
  for (const int n : cuts)
    expect_no_work(test::cylinder_in_hole(), test::cylinder_loop(ticks), {n});
}
void wedge(const std::vector<int>& cuts) {
  for (const int n : cuts) expect_no_work(test::wedge_in_notch(), test::wedge_loop(ticks), {n});
}
/// Pushed aside by far more than the clearance, so that the energy stored stands out of what the
/// residual of an answer (1e-4 of the depth) does along the axis, a way a hundred times as long.
/// Guided at the mouth, where edges that pass each other let go, some by less than counts as jump.
void expect_no_work_of_peg(const std::vector<int>& cuts, double lowest,
                           const std::vector<double>& clearances) {
  for (const double clearance : clearances)
    for (const int n : cuts) {
      const auto scene = test::peg_in_hole(
          clearance,
          {.shift = 2e-3, .tilt = 0.01, .lowest = lowest, .step = 1e-5, .guided = 0.004});
      expect_no_work(scene, scene.path, {n});
    }
}
constexpr double above_the_bottom = 1e-3, onto_the_bottom = -5e-4;  ///< where it turns back, m

const std::vector<int> coarsest = {1}, all = {2, 7, 16, 24};

// The reference of the others, and that the loops themselves are fit for the test.
TEST(ConformingEnergy, coarse_block_on_a_slab_gives_the_hand_no_work) {
  expect_no_work_of_block(coarsest);
}
TEST(ConformingEnergy, coarse_cylinder_in_a_hole_gives_the_hand_no_work) { cylinder(coarsest); }
TEST(ConformingEnergy, coarse_wedge_in_a_notch_gives_the_hand_no_work) { wedge(coarsest); }
TEST(ConformingEnergy, coarse_peg_in_a_hole_gives_the_hand_no_work) {
  expect_no_work_of_peg(coarsest, above_the_bottom, {1e-4});
}

TEST(ConformingEnergy, fine_block_on_a_slab_gives_the_hand_no_work) {
  expect_no_work_of_block({16});
}
TEST(ConformingEnergy, fine_wedge_in_a_notch_gives_the_hand_no_work) { wedge({8}); }
TEST(ConformingEnergy, Full_fine_block_on_a_slab_gives_the_hand_no_work) {
  expect_no_work_of_block(all);
}
TEST(ConformingEnergy, Full_fine_cylinder_in_a_hole_gives_the_hand_no_work) { cylinder(all); }
TEST(ConformingEnergy, Full_fine_wedge_in_a_notch_gives_the_hand_no_work) { wedge(all); }
TEST(ConformingEnergy, Full_fine_peg_in_a_hole_gives_the_hand_no_work) {
  expect_no_work_of_peg({1, 2, 7, 24}, above_the_bottom, {1e-5, 1e-4, 5e-4});
}
TEST(ConformingEnergy, Full_peg_pressed_onto_the_bottom_gives_the_hand_no_work) {
  expect_no_work_of_peg({1, 7, 24}, onto_the_bottom, {1e-5, 1e-4, 5e-4});
}

}  // namespace
}  // namespace sonde
