// SPDX-License-Identifier: GPL-3.0-or-later
// The brute-force search where the answer is known: a sphere, which gains nothing by turning, in a
// large box.
#include "tests/reference/brute_search.hpp"

#include <gtest/gtest.h>

#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::reference {
namespace {

class SphereInBox : public testing::Test {
 protected:
  BruteOptions options(Method method) const {
    BruteOptions out;
    out.method = method;
    out.directions = 50, out.starts = 20, out.hops = 5, out.seed = 4;
    return out;
  }
  // Facets of a twentieth of a right angle: the radius is certain to 0.1 %.
  std::shared_ptr<const Body> sphere = test::body(test::sphere(0.05, 40, 80));
  std::shared_ptr<const Body> box = test::body(test::box({0.4, 0.5, 0.6}));
  Pose pose{Quat::Identity(), {0.16, 0.02, -0.03}};
  double exact = 0.2 - 0.16 + 0.05;  // out by the nearest face
};

TEST_F(SphereInBox, depth_is_that_of_the_nearest_face) {
  const BruteResult found = brute_search(*sphere, *box, pose, options(Method::pdg));
  EXPECT_NEAR(found.depth, exact, 2e-3 * exact);
  EXPECT_FALSE(overlap(*sphere, *box, Transform(found.separated), Doubt::exact));
  EXPECT_LE(found.reached.size(), 20U);
  EXPECT_GE(found.reached.size(), 15U);
}

TEST_F(SphereInBox, translation_alone_does_as_well_and_does_not_turn) {
  const BruteResult found = brute_search(*sphere, *box, pose, options(Method::pdt));
  EXPECT_NEAR(found.depth, exact, 2e-3 * exact);
  EXPECT_LT(found.separated.q.vec().norm(), 1e-12);
}

TEST_F(SphereInBox, same_seed_gives_the_same_bits) {
  const auto once = brute_search(*sphere, *box, pose, options(Method::pdg));
  const auto again = brute_search(*sphere, *box, pose, options(Method::pdg));
  EXPECT_EQ(once.depth, again.depth);
  EXPECT_EQ(once.reached, again.reached);
}

}  // namespace
}  // namespace sonde::reference
