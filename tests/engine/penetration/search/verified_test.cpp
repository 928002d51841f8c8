// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/verified.hpp"

#include <gtest/gtest.h>

#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Reference: a box on a plate, 0.01 deep, comes out upwards by that.
TEST(Verified, keeps_the_nearest_answer_that_is_free) {
  const auto box = test::body(test::box({0.1, 0.08, 0.06})),
             plate = test::body(test::box({2, 2, 1}));
  const Pair pair(box, plate);
  const Chart chart(box->mass, {Quat::Identity(), Vec3(0.02, -0.01, 0.5 + 0.03 - 0.01)});
  Verified verified(pair, chart);
  EXPECT_FALSE(verified.best());
  LeapDescent leaps(*box, *plate, Method::pdg);

  Vec6 far = Vec6::Zero();
  far[5] = 0.02;
  const Separation up = verified.refined(Method::pdg, far, leaps, 50, {});
  test::check_separation(*box, *plate, up, "up");
  EXPECT_NEAR(up.depth, 0.01, 1e-5);

  Separation overlapping = up;
  overlapping.depth = 0.5 * up.depth, overlapping.separated.p.z() -= 0.5 * up.depth;
  verified.add(overlapping);
  EXPECT_FALSE(verified.best()) << "it is not free";
  verified.add(up);
  ASSERT_TRUE(verified.best());
  Separation higher = up;
  higher.depth = 2 * up.depth, higher.separated.p.z() += up.depth;
  verified.add(higher);
  EXPECT_EQ(verified.best()->depth, up.depth);
}

}  // namespace
}  // namespace sonde
