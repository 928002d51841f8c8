// SPDX-License-Identifier: GPL-3.0-or-later
// The coherent solver on paths that no hand makes. The reference is geometry by hand: a brick that
// is pressed flat into a plate comes straight out by as much as it is in.
#include <algorithm>
#include <random>

#include "engine/penetration/search/coherent.hpp"
#include "tests/extremes/press.hpp"

namespace sonde {
namespace {

using test::brick_and_plate;

/// Flat above the plate's top face, and into it by `deep`; below zero, off it.
Pose flat_at(double x, double y, double deep) {
  return {Quat::Identity(), Vec3(x, y, 0.5 + 0.03 - deep)};
}

bool is_free(const Pair& pair, const Pose& X_FM) {
  return !overlap(pair.probe(), pair.fixed(), Transform(X_FM), Doubt::exact);
}

TEST(PathExtremes, after_each_of_200_teleports_the_depth_is_the_one_by_hand) {
  const Pair pair = brick_and_plate();
  CoherentSolver solver(pair);
  solver.reset(flat_at(0, 0, -0.01));
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-0.8, 0.8), depth(-0.05, 0.05);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const double deep = depth(random);
    const Separation& s = solver.tick(flat_at(place(random), place(random), deep));
    EXPECT_TRUE(is_free(pair, s.separated)) << i;
    EXPECT_TRUE(s.converged) << i;
    EXPECT_EQ(s.status, deep > 0 ? Status::penetrating : Status::separated)
        << i << ": " << s.reason;
    if (deep <= 0) continue;
    EXPECT_GE(s.depth, deep * (1 - 1e-6)) << i;
    EXPECT_LE(s.depth, deep * (1 + 1e-6) + test::promised_clearance(pair.probe().mass.radius, deep))
        << i;
    worst = std::max(worst, s.depth / deep - 1);
  }
  std::printf("  200 teleports: %.2g above the reference\n", worst);
}

TEST(PathExtremes, standing_still_for_a_hundred_thousand_ticks_changes_nothing) {
  const Pair pair = brick_and_plate();
  CoherentSolver solver(pair);
  solver.reset(flat_at(0, 0, -0.01));
  const Pose still = flat_at(0.1, -0.2, 0.01);
  for (int i = 0; i < 10; ++i) solver.tick(still);
  const Separation settled = solver.last();
  EXPECT_NEAR(settled.depth, 0.01, test::promised_clearance(pair.probe().mass.radius, 0.01));
  for (int i = 0; i < 100'000; ++i) solver.tick(still);
  EXPECT_EQ(solver.last().depth, settled.depth);
  EXPECT_EQ(solver.last().separated.p, settled.separated.p);
  EXPECT_EQ(solver.last().separated.q.coeffs(), settled.separated.q.coeffs());
}

}  // namespace
}  // namespace sonde
