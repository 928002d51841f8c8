// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/pair_lists.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/proximity/queries/near_pairs.hpp"
#include "tests/support/conforming.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::body;

/// A rod of 120 sides that slides along its hole, 0.1 mm a tick, at a gap of 1 µm. It comes out
/// of it at the 200th.
struct Sliding {
  std::shared_ptr<const Body> rod = body(test::cut_rod(0.01, 0.1, 120, {}));
  std::shared_ptr<const Body> hole = body(test::cut_bored_block(0.03, 0.1, 0.010001, 120, {}));
  double step = 1e-4;
  Transform at(int tick) const {
    return Transform(Pose{Quat::Identity(), {0, 0, -0.02 + tick * step}});
  }
};

struct Outcome {
  int without = 0;  ///< ticks that had no list when it was asked for
  int made = 0;     ///< lists that came to serve
};

/// As a follower uses them: `wanted` is asked for at the start of a tick, a path is swept, and what
/// is left of the tick's effort goes into the next list.
Outcome slide(const Sliding& scene, std::int64_t work, double wanted, double will_do) {
  PairLists lists(*scene.rod, *scene.hole, NeighbourList::enough(*scene.rod, *scene.hole));
  std::vector<NearPair> from_list(1 << 14), from_trees(1 << 14);
  Outcome out;
  const Vec3 centre = scene.rod->mass.com;
  const NeighbourList* last = nullptr;
  for (int tick = 0; tick < 180; ++tick) {
    Effort effort(work, 0);
    const Transform X = scene.at(tick);
    const auto path = [&] { return LinearizedMotion{lists.recent_course(X, centre), {}}; };
    if (lists.serving().reach_at(X) < will_do)
      lists.renew(X, {wanted, 2 * will_do, will_do, centre, path()}, effort);
    NeighbourList& list = lists.serving();
    const double reach = list.reach_at(X);
    const bool served = reach >= will_do;
    out.without += !served && tick > 20;
    out.made += served && &list != last;
    if (served) last = &list;
    if (served && tick % 20 == 0) {
      Effort unlimited;
      const double asked = std::min(reach, wanted);
      const auto got = list.near(X, asked, from_list, unlimited);
      const auto want = near_pairs(*scene.rod, *scene.hole, X, asked, from_trees);
      EXPECT_EQ(got.count, want.count) << tick;
    }
    const Chart chart(scene.rod->mass, Pose{Quat::Identity(), X.p});
    Vec6 y = Vec6::Zero();
    y[5] = scene.step;
    lists.note_path(Motion(chart, Vec6::Zero(), y));
    lists.prepare_next_list(X, {will_do, 2 * will_do, will_do, centre, path()}, effort);
  }
  return out;
}

// Reference: near_pairs, itself tested against all pairs; a list is there or not.
TEST(PairLists, one_made_ahead_serves_where_it_will_do) {
  const Sliding scene;
  PairLists lists(*scene.rod, *scene.hole, NeighbourList::enough(*scene.rod, *scene.hole));
  Effort unlimited;
  const double will_do = 1e-5;
  lists.renew(scene.at(0), {will_do, 2 * will_do, will_do, scene.rod->mass.com, {}}, unlimited);
  const std::int64_t a_list = lists.serving().work_of_build();
  ASSERT_GT(a_list, 1000);
  // Far more is wanted than a list along the course has beside it.
  const Outcome found = slide(scene, a_list / 2, 20 * will_do, will_do);
  EXPECT_EQ(found.without, 0);
  EXPECT_GT(found.made, 10);
  EXPECT_LT(found.made, 60);
}

}  // namespace
}  // namespace sonde
