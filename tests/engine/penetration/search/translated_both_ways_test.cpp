// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/translated_both_ways.hpp"

#include <gtest/gtest.h>

#include <random>
#include <tuple>

#include "engine/penetration/search/search.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Reference: a way out of one body, reversed, is a way out of the other.
TEST(TranslatedBothWays, exchanged_bodies_have_the_same_depth_and_the_reverse_way) {
  std::mt19937_64 random(5);
  const Pair knots(test::body(test::torus_knot(2, 3, 0.06, 0.025, 0.012, 60, 8)),
                   test::body(test::torus(0.07, 0.02, 30, 12)));
  const Pair alike(test::body(test::torus(0.07, 0.02, 24, 10)),
                   test::body(test::torus(0.07, 0.02, 24, 10)));
  const StaticOptions options{.method = Method::pdt, .want_lower_bound = false};
  int compared = 0;
  for (const Pair* pair : {&knots, &alike})
    for (int i = 0; i < 8; ++i) {
      const Pose X{test::random_rotation(random), test::random_in_ball(random, 0.05)};
      const Separation one = translated_both_ways(*pair, X, options, search_tuning, {}).found;
      const Separation other =
          translated_both_ways(pair->exchanged(), inverse(X), options, search_tuning, {}).found;
      ASSERT_EQ(one.status, other.status) << i;
      if (one.status != Status::penetrating) continue;
      ++compared;
      EXPECT_NEAR(one.depth, other.depth, 1e-3 * one.depth) << i;
    }
  EXPECT_GE(compared, 12);
}

// Reference: the one search by itself; the body with fewer triangles, or less volume, goes first.
TEST(TranslatedBothWays, one_way_is_enough_where_it_settles_the_answer) {
  const StaticOptions options{.method = Method::pdt, .want_lower_bound = false};
  const auto plate = test::body(test::box({1, 1, 0.2})), ball = test::body(test::sphere(1, 24, 32));
  const auto cube = test::body(test::box({0.1, 0.1, 0.1})),
             bar = test::body(test::box({0.3, 0.05, 0.2}));
  const std::tuple<Pair, Vec3> sunk[] = {{Pair(cube, plate), {0.01, 0.02, 0.13}},
                                         {Pair(bar, plate), {-0.2, 0.1, 0.18}},
                                         {Pair(cube, ball), {0.1, 0.3, 0.95}}};
  for (const auto& [pair, at] : sunk) {
    const Pose X{Quat::Identity(), at};
    Search alone(pair, X, options, search_tuning, {});
    const Separation found = alone.run();
    ASSERT_TRUE(alone.is_settled());
    const Translated both = translated_both_ways(pair, X, options, search_tuning, {});
    const Translated back =
        translated_both_ways(pair.exchanged(), inverse(X), options, search_tuning, {});
    EXPECT_EQ(both.found.depth, found.depth);
    EXPECT_NEAR(back.found.depth, found.depth, 1e-6 * found.depth);
    EXPECT_EQ(both.sketches, alone.sketches_made());
    EXPECT_EQ(back.sketches, alone.sketches_made());
  }
}

// Reference: a cube on a plate's side goes out by its overlap.
TEST(TranslatedBothWays, a_box_goes_out_of_a_plate_by_the_side_it_is_near) {
  const Pair pair(test::body(test::box({0.1, 0.1, 0.1})), test::body(test::box({1, 1, 0.2})));
  const StaticOptions options{.method = Method::pdt, .want_lower_bound = false};
  const auto [found, sketches] = translated_both_ways(pair, {Quat::Identity(), {0.01, 0.02, 0.13}},
                                                      options, search_tuning, {});
  ASSERT_EQ(found.status, Status::penetrating);
  EXPECT_NEAR(found.depth, 0.02, 1e-5);
  EXPECT_GT(sketches, 0);
}

}  // namespace
}  // namespace sonde
