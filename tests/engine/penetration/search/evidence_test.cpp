// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/evidence.hpp"

#include <gtest/gtest.h>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A box in a larger one, 0.17 m deep by translation alone (a closed form), with some starts made
/// on their sketches.
class EvidenceTest : public ::testing::Test {
 protected:
  static constexpr double depth = 0.15 + 0.05 - 0.03;
  EvidenceTest() { sketches_.make_starts(256, search_tuning.clear); }
  Evidence evidence(Evidence::Rules rules) { return {chart_, rules, optima_, sketches_, lanes_}; }
  void find(double at, int starts) {
    optima_.add({.y = Vec6::Unit(5) * at, .depth = at, .starts = starts});
  }
  SketchEnd& first_end() { return sketches_.ends().front(); }

  std::shared_ptr<const Body> small_ = test::body(test::box({0.1, 0.1, 0.1}));
  std::shared_ptr<const Body> large_ = test::body(test::box({0.4, 0.4, 0.3}));
  Chart chart_{small_->mass, Pose{Quat::Identity(), Vec3(0.02, 0.01, 0.03)}};
  Sketches drawn_ = make_sketches(*small_, *large_);
  std::vector<SketchDescent> lanes_{2, SketchDescent(*drawn_.probe, *drawn_.fixed, large_->mass)};
  ThreadPair threads_{false};
  SketchSearch sketches_{chart_, {.method = Method::pdt}, lanes_, threads_};
  LocalOptima optima_;
};

TEST_F(EvidenceTest, nothing_is_settled_before_anything_was_found) {
  EXPECT_FALSE(evidence({}).is_conclusive());
  EXPECT_FALSE(evidence({}).sketches_see());
}

TEST_F(EvidenceTest, as_many_starts_as_asked_settle_it_without_sketches) {
  find(depth, 3);
  EXPECT_FALSE(evidence({.agreement = 4, .by_sketches = false}).is_conclusive());
  find(depth, 1);
  EXPECT_TRUE(evidence({.agreement = 4, .by_sketches = false}).is_conclusive());
  find(depth / 2, 1);
  EXPECT_FALSE(evidence({.agreement = 4, .by_sketches = false}).is_conclusive())
      << "a better one is new";
}

TEST_F(EvidenceTest, sketches_settle_it_where_the_bodies_came_to_the_same_place) {
  ASSERT_TRUE(sketches_.is_clear(search_tuning.clear));
  find(depth, 1);
  EXPECT_TRUE(evidence({}).sketches_see());
  EXPECT_FALSE(evidence({}).is_conclusive()) << "no descent of the bodies began there";
  first_end().came_to = depth;
  EXPECT_TRUE(evidence({}).is_conclusive());
  EXPECT_FALSE(evidence({.agreement = 1000, .by_sketches = false}).is_conclusive());
  first_end().came_to = 2 * depth;
  EXPECT_FALSE(evidence({}).is_conclusive()) << "it ended elsewhere";
}

TEST_F(EvidenceTest, sketches_that_miss_what_holds_the_bodies_are_none) {
  find(2 * search_tuning.rough_error * depth, 1);
  first_end().came_to = 2 * search_tuning.rough_error * depth;
  EXPECT_FALSE(evidence({}).sketches_see());
  EXPECT_FALSE(evidence({}).is_conclusive());
}

// The middle of the lower face of the small box lies 0.13 m deep in the large one, 0.07 m its upper
// face; no point of it lies deeper than 0.15 m.
TEST_F(EvidenceTest, a_way_out_much_longer_than_the_overlap_is_deep_may_be_narrow) {
  first_end().came_to = depth;
  EXPECT_TRUE(evidence({}).may_be_narrow()) << "as long as it is open";
  find(depth, 12);
  EXPECT_FALSE(evidence({}).may_be_narrow());
  SearchTuning strict;
  strict.narrow_for_pushes = 1;
  EXPECT_TRUE(evidence({.tuned = strict}).may_be_narrow());
  EXPECT_FALSE(evidence({.tuned = strict}).may_be_deep()) << "a few pushes are enough";
  strict.narrow = 1;
  EXPECT_TRUE(evidence({.tuned = strict}).may_be_deep());
}

}  // namespace
}  // namespace sonde
