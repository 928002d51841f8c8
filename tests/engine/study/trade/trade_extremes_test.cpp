// SPDX-License-Identifier: GPL-3.0-or-later
// A power of two changes no digit, so a scaled world must give the same numbers, scaled; far from
// the origin coordinates are rounded, by 10⁴ R times 2^-53 at each corner.
#include "engine/study/trade/trade_extremes.hpp"

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::never;

std::vector<Pose> some_poses() {
  const Quat q(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  return {{q, Vec3(0.02, 0.03, 0.01)}, {q.conjugate(), Vec3(-0.05, 0.01, 0.02)}};
}

TEST(TradeExtremes, answers_do_not_depend_on_size_and_hardly_on_place) {
  const auto ring = test::body(test::torus(0.06, 0.02, 24, 12));
  const auto box = test::body(test::box({0.05, 0.04, 0.08}));
  const auto all = measure_extremes({box, ring}, some_poses(), 1, never);
  ASSERT_EQ(all.size(), 9u) << "three worlds, two methods and the bound";
  for (const TradeExtreme& extreme : all) {
    ASSERT_EQ(extreme.change.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
      const double change = extreme.change[i];
      if (extreme.world != "far") {
        EXPECT_EQ(change, 0) << extreme.world << " " << name_of(extreme.kind);
      } else if (extreme.kind == TradeKind::search) {
        // A search stops at a residual of 1e-4, and leaves a clearance of 1e-4 of the depth.
        EXPECT_NEAR(change, 0, 1e-3);
      } else {  // other points may be found to prove it by, but none that proves too much
        const Separation s = separate_static({box, ring}, some_poses()[i]);
        EXPECT_GT(change, -1);
        EXPECT_LE((1 + change) * s.lower_bound.value(), s.depth);
      }
    }
  }
}

TEST(TradeExtremes, surfaces_have_no_bound_and_failures_are_no_numbers) {
  std::mt19937_64 random(5);
  const auto soup = test::body(test::random_soup(random, 30, 0.1));
  const auto all = measure_extremes({soup, soup}, some_poses(), 1, never);
  EXPECT_EQ(all.size(), 6u);
  for (const TradeExtreme& extreme : all) EXPECT_EQ(extreme.kind, TradeKind::search);
  EXPECT_THROW(measure_extremes({soup, soup}, some_poses(), 1, [] { return true; }), Cancelled);
}

}  // namespace
}  // namespace sonde
