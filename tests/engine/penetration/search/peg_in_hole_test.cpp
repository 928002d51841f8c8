// SPDX-License-Identifier: GPL-3.0-or-later
// A keyed peg lowered into its blind hole and drawn out again, off its axis and askew by more than
// the clearance allows: nothing holds it back. References: the pose beside the device on the axis,
// which is free by construction, so that the depth is at most σ's root from there; and the same
// shapes in their coarsest mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "engine/penetration/search/coherent.hpp"
#include "tests/engine/penetration/conforming_checks.hpp"
#include "tests/support/brute_force.hpp"

namespace sonde {
namespace {

using test::Cutting;
using test::Felt;
using test::Worst;

constexpr double tenth_of_a_degree = 1.745e-3;
constexpr double arm = 0.015;

std::string describe(double clearance, double shift, const Cutting& cutting) {
  return "peg, clearance " + std::to_string(clearance / test::peg_radius) + " R, off by " +
         std::to_string(shift / test::peg_radius) + " R, n = " + std::to_string(cutting.n);
}

// Reference: exact predicates on all pairs of triangles.
TEST(PegInHole, is_free_on_its_axis_all_the_way_down) {
  for (const double clearance : {1e-5, 1e-4, 5e-4})
    for (const int n : {1, 2}) {
      const auto bodies = cut_bodies(test::peg_in_hole(clearance, {}), {n});
      for (const double z : {0.001, 0.0, -0.0005, -0.0013, -0.01, -1.0}) {
        const Pose X = test::peg_on_axis({Quat::Identity(), Vec3(0, 0, z)});
        EXPECT_TRUE(test::is_free(*bodies.probe, *bodies.fixed, Transform(X)))
            << clearance << ' ' << n << ' ' << z;
      }
    }
}

/// Nothing sticks: what is felt is explained by how far the device is from the axis.
std::vector<Felt> expect_no_sticking(double clearance, double shift, double lowest,
                                     const Cutting& cutting) {
  const std::string what = describe(clearance, shift, cutting);
  const auto scene = test::peg_in_hole(clearance, {shift, tenth_of_a_degree, lowest});
  const auto bodies = cut_bodies(scene, cutting);
  const auto felt = follow(bodies, scene.path);
  // Where it is wide, the peg may lean on a wall in two ways, and one of them ends somewhere; the
  // narrower one slips into its hole once. (These are falls: at a half and a quarter of the step
  // they let go about as much.)
  expect_followed(felt, 1e-3, what, clearance > 2e-4 ? 2 : clearance > 5e-5 ? 1 : 0);
  expect_free_at_the_ends(felt, what);
  Worst deep, pull;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const Pose& X = scene.path[i];
    const double reason = test::object_distance(bodies.probe->mass, X, test::peg_on_axis(X));
    deep.see(felt[i].depth / reason, i);
    // All walls are upright and the peg is askew by a tenth of a degree: no normal points down by
    // more than that, and pairs of opposite contacts carry no more than some of the depth each.
    pull.see(-felt[i].force.z() / (test::felt_stiffness * reason), i);
  }
  EXPECT_LE(deep.value, 1.001) << what << ": depth beside that on the axis, at tick " << deep.tick;
  EXPECT_LE(pull.value, 0.01) << what << ": pull into the hole, at tick " << pull.tick;
  return felt;
}

/// Away from jumps, which need not come in the same tick.
void expect_as(const std::vector<Felt>& felt, const std::vector<Felt>& want,
               const std::string& what) {
  // Of opposite contacts little is left as force: the deepest tick sets the scale.
  const double scale = test::largest_force(want);
  Worst force, torque;
  for (std::size_t i = 0; i < felt.size(); ++i) {
    bool jumps = false;
    for (std::size_t j = i < 3 ? 0 : i - 3; j < std::min(i + 4, felt.size()); ++j)
      jumps |= felt[j].jumped || want[j].jumped;
    if (jumps) continue;
    force.see((felt[i].force - want[i].force).norm() / scale, i);
    torque.see((felt[i].torque - want[i].torque).norm() / (scale * arm), i);
  }
  EXPECT_LE(force.value, 0.01) << what << ": force, worst at tick " << force.tick;
  EXPECT_LE(torque.value, 0.01) << what << ": torque, worst at tick " << torque.tick;
}

/// Off the axis by the clearance and half as much again, and by the perturbation.
void comes_out_of_holes(const std::vector<int>& cuts, double lowest,
                        const std::vector<double>& perturbations) {
  for (const double clearance : {1e-5, 1e-4, 5e-4})
    for (const double perturbation : perturbations) {
      const double shift = 1.5 * clearance + perturbation;
      std::vector<Felt> want;
      for (const int n : cuts) {
        const auto felt = expect_no_sticking(clearance, shift, lowest, {n});
        if (want.empty()) want = felt;
        expect_as(felt, want, describe(clearance, shift, {n}));
      }
    }
}

constexpr double above_the_bottom = 1e-3, onto_the_bottom = -5e-4;  ///< where it turns back, m

TEST(PegInHole, comes_out_without_sticking) {
  comes_out_of_holes({1, 8}, above_the_bottom, {1e-5});
}
TEST(PegInHole, Full_comes_out_without_sticking) {
  comes_out_of_holes({1, 4, 12, 24, 32}, above_the_bottom, {1e-6, 1e-5});
}
// Its flat tip on the flat bottom, and its wall against the hole's.
TEST(PegInHole, pressed_onto_the_bottom_it_comes_out_without_sticking) {
  comes_out_of_holes({1, 8}, onto_the_bottom, {1e-5});
}
TEST(PegInHole, Full_pressed_onto_the_bottom_it_comes_out_without_sticking) {
  comes_out_of_holes({1, 4, 12, 24, 32}, onto_the_bottom, {1e-6, 1e-5});
}

// Reference: the clearance, which is wider than a point of the peg is off its place: by the shift,
// by the tilt over the depth of the hole, and by the turn over the reach of the key.
void is_not_felt(const std::vector<int>& cuts, const std::vector<double>& shifts) {
  for (const double clearance : {1e-4, 5e-4})
    for (const double shift : shifts)
      for (const int n : cuts) {
        ASSERT_GT(clearance, shift + tenth_of_a_degree * (test::socket_depth + 0.012));
        const auto scene = test::peg_in_hole(clearance, {shift, tenth_of_a_degree, 1e-4});
        const auto felt = follow(cut_bodies(scene, {n}), scene.path);
        for (std::size_t i = 0; i < felt.size(); ++i) {
          ASSERT_EQ(felt[i].status, Status::separated) << describe(clearance, shift, {n}) << i;
          ASSERT_EQ(felt[i].force, Vec3(Vec3::Zero())) << describe(clearance, shift, {n}) << i;
        }
      }
}

TEST(PegInHole, is_not_felt_inside_its_clearance) { is_not_felt({1, 12}, {1e-5}); }
TEST(PegInHole, Full_is_not_felt_inside_its_clearance) {
  is_not_felt({1, 4, 24, 40}, {1e-6, 1e-5});
}

}  // namespace
}  // namespace sonde
