// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/search_worker.hpp"

#include <gtest/gtest.h>

#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

class LaneTest : public testing::Test {
 protected:
  const std::shared_ptr<const Body> ring = test::body(test::torus(0.08, 0.03, 20, 10)),
                                    plate = test::body(test::box({1, 1, 0.2}));
  const Chart chart{ring->mass, Pose{Quat::Identity(), {0.01, 0.02, 0.12}}};
  const SearchTuning tuning{.tries_in_a_ball = 200};  // one of them is free, surely enough
  SearchWorker lane{*ring, *plate, tuning};
  Random random{3};
};

// References: exact predicates, and |y| itself.
TEST_F(LaneTest, descents_end_free_nearer_and_within_their_steps) {
  for (const Method method : {Method::pdg, Method::pdt})
    for (const int steps : {1, 5, 100}) {
      const auto y = lane.free_sample(chart, random, Vec6::Zero(), 0.2, method, {});
      ASSERT_TRUE(y);
      for (const LocalOptimum& end : {lane.descend(chart, *y, method, {steps, 0, {}}),
                                      lane.descend_exactly(chart, *y, method, {steps, 0, {}})}) {
        EXPECT_LE(end.depth, y->norm());
        EXPECT_EQ(end.depth, end.y.norm());
        EXPECT_LE(end.iterations, steps);
        EXPECT_FALSE(overlap(*ring, *plate, Transform(chart.pose(end.y)), Doubt::exact));
        EXPECT_TRUE(method == Method::pdg || end.y.head<3>().isZero(0));
      }
    }
}

TEST_F(LaneTest, more_steps_of_a_descent_go_on_where_fewer_stop) {
  const auto y = lane.free_sample(chart, random, Vec6::Zero(), 0.2, Method::pdg, {});
  ASSERT_TRUE(y);
  double before = y->norm();
  for (int steps = 1; steps < 30; ++steps) {
    const double depth = lane.descend(chart, *y, Method::pdg, {steps, 0, {}}).depth;
    EXPECT_LE(depth, before) << steps;
    before = depth;
  }
}

// References: exact predicates, and what is found without sketches.
TEST_F(LaneTest, sketches_pass_over_no_free_pose_and_let_no_other_through) {
  const Sketches sketches = make_sketches(*ring, *plate);
  SketchDescent descent(*sketches.probe, *sketches.fixed, plate->mass);
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random with(seed), without(seed);
    const auto sample = [&](Random& from, SketchDescent* asked) {
      return lane.free_sample(chart, from, Vec6::Zero(), 0.15, Method::pdg, {}, asked);
    };
    const auto y = sample(with, &descent), other = sample(without, nullptr);
    ASSERT_TRUE(y && other) << seed;
    EXPECT_EQ(*y, *other) << seed;
    EXPECT_FALSE(overlap(*ring, *plate, Transform(chart.pose(*y)), Doubt::exact)) << seed;
  }
}

TEST_F(LaneTest, samples_of_translations_do_not_turn) {
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(lane.sample(random, 1, Method::pdt).head<3>().isZero(0));
    EXPECT_LE(lane.sample(random, 0.5, Method::pdg).norm(), 0.5);
  }
}

}  // namespace
}  // namespace sonde
