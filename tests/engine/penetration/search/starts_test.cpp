// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/starts.hpp"

#include <gtest/gtest.h>

#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/fitted_parts.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

class StartsTest : public testing::Test {
 protected:
  const std::shared_ptr<const Body> ring = test::body(test::torus(0.08, 0.03, 20, 10)),
                                    plate = test::body(test::box({1, 1, 0.2}));
  const Pair pair{ring, plate};
  const Chart chart{ring->mass, Pose{Quat::Identity(), {0.01, 0.02, 0.12}}};
  Starts starts{pair, chart, {}};

  Aim aim(Method method, double beat) const { return {method, beat, 50, nullptr}; }
  /// References: exact predicates, and |y| itself.
  void check(const LocalOptimum& place, Method method) const {
    ASSERT_TRUE(std::isfinite(place.depth));
    EXPECT_EQ(place.depth, place.y.norm());
    EXPECT_LE(place.iterations, 50);
    EXPECT_FALSE(overlap(*ring, *plate, Transform(chart.pose(place.y)), Doubt::exact));
    EXPECT_TRUE(method == Method::pdg || place.y.head<3>().isZero(0));
  }

  /// Few poses about an end of a flat contact are free, so one start of several finds one.
  LocalOptimum near_end(const LocalOptimum& end, Method method, std::size_t lane) {
    LocalOptimum out;
    for (std::uint64_t seed = 1; seed <= 8 && !std::isfinite(out.depth); ++seed)
      out = starts.descend_near_end(end.y, Random(seed), aim(method, end.depth), lane);
    return out;
  }
};

constexpr double nothing_found = std::numeric_limits<double>::infinity();

// Reference for the depth: the ring lies flat over the plate's top, 0.1 from its middle, and comes
// out upwards by 0.01 (its tube's radius is 0.03, its middle 0.12 up).
TEST_F(StartsTest, ends_are_free_and_starts_at_contact_come_out_by_the_nearest_face) {
  for (const Method method : {Method::pdg, Method::pdt})
    for (std::size_t lane = 0; lane < 2; ++lane) {
      const LocalOptimum pushed =
          starts.push_apart_and_descend(Vec6::Zero(), aim(method, nothing_found), lane);
      check(pushed, method);
      EXPECT_LT(pushed.depth, 0.0102);
      EXPECT_EQ(pushed.starts, 0) << "it began at the device pose";
      check(starts.descend_from_nearest_free(Random(1), aim(method, nothing_found), lane), method);
      check(starts.descend_from_ball(Random(2), aim(method, 0.3), lane), method);
      check(near_end(pushed, method, lane), method);
      check(starts.descend_from_outside(lane, aim(Method::pdt, nothing_found), lane), Method::pdt);
    }
}

TEST_F(StartsTest, an_end_on_sketches_that_is_not_free_is_freed) {
  ASSERT_EQ(starts.sketch_descents().size(), 2U);
  for (const double short_of_it : {0.0, 0.3, 0.9}) {
    SketchEnd end;
    end.y = Vec6::Zero();
    end.y[5] = 0.0101 * (1 - short_of_it);
    check(starts.descend_from_sketch_end(end, aim(Method::pdg, nothing_found), 0), Method::pdg);
  }
}

TEST_F(StartsTest, what_is_known_is_not_descended_again) {
  const LocalOptimum first =
      starts.push_apart_and_descend(Vec6::Zero(), aim(Method::pdg, nothing_found), 0);
  LocalOptima known;
  known.add(first);
  Aim again = aim(Method::pdg, first.depth);
  again.known = &known;
  EXPECT_FALSE(std::isfinite(starts.push_apart_and_descend(Vec6::Zero(), again, 0).depth));
}

TEST(Starts, surfaces_have_no_sketches) {
  std::mt19937_64 random(1);
  const auto soup = test::body(test::random_soup(random, 12, 0.1));
  const Pair pair(soup, soup);
  const Chart chart(soup->mass, {});
  EXPECT_TRUE(Starts(pair, chart, {}).sketch_descents().empty());
}

// Reference: the fit itself, whose y is known: a plug with five points belongs in a hole of its
// shape, 0.04 of its radius wider, whose centre is not that of the body round it. It stands askew
// in it, and by half of the angle between two points turned about its axis.
TEST(FittedStarts, the_spin_and_the_place_across_the_axis_are_those_of_the_least_overlap) {
  test::Section hole = test::toothed_section(5, 0.008, 0.016);
  const auto plug = test::body(test::fitted_plug(hole, 0.007, {}));
  // A block at one side moves the centre of mass, and turns no principal axis by more than a
  // little.
  const auto body =
      test::body(test::joined(test::fitted_socket(test::grown(hole, 0.0006), 1.6, 0.010, {}),
                              test::box({0.01, 0.012, 0.016}), {0.04, 0, 0}));
  ASSERT_GT(body->mass.com.head<2>().norm(), 0.0006) << "the axes would meet without a search";
  const Pair pair{plug, body};
  const Pose device{Quat(Eigen::AngleAxisd(0.6, Vec3(0.05, 0.02, 1).normalized())),
                    {0.001, 0.0005, 0.001}};
  const Chart chart(plug->mass, device);
  const double fit = chart.coordinates({Quat::Identity(), {0, 0, 0.001}}).norm();
  Starts starts(pair, chart, {});
  ASSERT_FALSE(starts.sketch_descents().empty());
  int within = 0, found = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const auto place = starts.fitted(random, 1.2 * fit, 0);
    if (!place) continue;
    ++within;
    EXPECT_LT(place->y.norm(), 1.2 * fit) << seed;
    EXPECT_EQ(place->overlap, starts.sketch_descents()[0].depth_of_points(chart, place->y)) << seed;
    const LocalOptimum end =
        starts.push_apart_and_descend(place->y, {Method::pdg, 1.2 * fit, 50, nullptr}, 0);
    if (!(end.depth < fit * (1 + 1e-6))) continue;
    ++found;
    EXPECT_FALSE(overlap(*plug, *body, Transform(chart.pose(end.y)), Doubt::exact)) << seed;
  }
  EXPECT_GE(found, 3) << "of " << within;
}

}  // namespace
}  // namespace sonde
