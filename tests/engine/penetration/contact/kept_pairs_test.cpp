// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/kept_pairs.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "engine/penetration/contact/contact_tuning.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A cube of 0.5 m, 0.25 m above another one at no displacement: without rounding.
struct Cubes {
  std::shared_ptr<const Body> probe = test::body(test::box(Vec3::Constant(0.5)));
  std::shared_ptr<const Body> fixed = test::body(test::box(Vec3::Constant(0.5)));
  KeptPairs kept{*probe, *fixed};
  std::vector<NearPair> pairs = std::vector<NearPair>(2 * contact_tuning.most_kept);

  static Transform at(double up) { return Transform(Pose{Quat::Identity(), {0, 0, 0.75 + up}}); }
  std::vector<TrianglePair> found(double reach, double up = 0, std::size_t before = 0) {
    const std::size_t count = kept.add_to(pairs, before, at(up), reach);
    std::vector<TrianglePair> out;
    for (std::size_t i = before; i < count; ++i)
      out.push_back({pairs[i].triangle_a, pairs[i].triangle_b});
    return out;
  }
  /// Reference: closest_points of one pair.
  double distance(const TrianglePair& pair, double up = 0) const {
    return closest_points(place(at(up), corners(surface(*probe), pair.a)),
                          corners(surface(*fixed), pair.b))
        .distance;
  }
  /// All pairs whose distance is below or above a limit.
  std::vector<TrianglePair> nearer(double limit, bool is_nearer = true) const {
    std::vector<TrianglePair> out;
    for (std::uint32_t a = 0; a < 12; ++a)
      for (std::uint32_t b = 0; b < 12; ++b)
        if ((distance({a, b}) < limit) == is_nearer) out.push_back({a, b});
    return out;
  }
};

TEST(KeptPairs, those_within_reach_are_added_in_their_order_and_the_others_forgotten) {
  Cubes cubes;
  const TrianglePair near = cubes.nearer(0.26).front(), far = cubes.nearer(0.5, false).front(),
                     other = cubes.nearer(0.26).back();
  for (const TrianglePair& pair : {near, far, other}) cubes.kept.keep(pair);
  EXPECT_EQ(cubes.found(0.3), (std::vector{near, other}));
  EXPECT_EQ(cubes.pairs[0].gap, 0.25);
  EXPECT_EQ(cubes.found(2), (std::vector{near, other}));  // `far` is forgotten
}

TEST(KeptPairs, those_that_meet_are_forgotten) {
  Cubes cubes;
  cubes.kept.keep(cubes.nearer(0.26).front());
  ASSERT_EQ(cubes.distance(cubes.nearer(0.26).front(), -0.25), 0);
  EXPECT_TRUE(cubes.found(2, -0.25).empty());
  EXPECT_TRUE(cubes.found(2).empty());
}

TEST(KeptPairs, one_that_is_there_already_is_not_added_again) {
  Cubes cubes;
  const auto near = cubes.nearer(0.26);
  ASSERT_GE(near.size(), 2u);
  cubes.pairs[0].triangle_a = near[0].a;
  cubes.pairs[0].triangle_b = near[0].b;
  cubes.kept.keep(near[0]);
  cubes.kept.keep(near[1]);
  EXPECT_EQ(cubes.found(0.3, 0, 1), std::vector{near[1]});
  EXPECT_EQ(cubes.found(0.3), (std::vector{near[0], near[1]}));  // but it is still kept
}

TEST(KeptPairs, where_there_is_no_room_the_oldest_is_forgotten) {
  Cubes cubes;
  const auto all = cubes.nearer(2);  // all 144
  const std::size_t room = contact_tuning.most_kept;
  ASSERT_GT(all.size(), room + 1);
  for (std::size_t i = 0; i < room; ++i) cubes.kept.keep(all[i]);
  cubes.kept.keep(all[0]);  // is the newest again
  cubes.kept.keep(all[room]);
  std::vector<TrianglePair> wanted(all.begin() + 2, all.begin() + static_cast<int>(room));
  wanted.push_back(all[0]);
  wanted.push_back(all[room]);
  EXPECT_EQ(cubes.found(2), wanted);
  cubes.kept.forget();
  EXPECT_TRUE(cubes.found(2).empty());
}

}  // namespace
}  // namespace sonde
