// SPDX-License-Identifier: GPL-3.0-or-later
// References: the coherent solver on the same poses, and all pairs within reach by near_pairs.
#include "engine/haptics/loop/contact_feed.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/proximity/queries/near_pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

struct TwoRings {
  std::shared_ptr<const Body> probe = test::body(test::torus(0.04, 0.015, 16, 10));
  std::shared_ptr<const Body> fixed = test::body(test::torus(0.06, 0.02, 16, 10));
};

Pose path(double x) {
  return {Quat(Eigen::AngleAxisd(0.5 * x, Vec3(1, 2, 3).normalized())),
          Vec3(0.01 * x, 0.002, 0.06 - 0.05 * x)};
}

/// No search at all, where one is needed.
StaticOptions nothing_to_search_with() {
  StaticOptions options;
  options.starts = 0;
  options.budget.steps = 1;
  return options;
}

TEST(ContactFeed, where_it_has_searched_before_it_does_not_search_again) {
  const TwoRings bodies;
  const Pose deep = path(1);
  ContactFeed feed({bodies.probe, bodies.fixed}, Method::pdg);
  const Separation found = feed.reset(deep, {}).separation;
  ASSERT_EQ(found.status, Status::penetrating);
  feed.refresh(path(0.2), 1, 1e-3, {});
  const LocalContacts& again = feed.reset(deep, nothing_to_search_with());
  EXPECT_EQ(again.separation.status, Status::penetrating);
  EXPECT_LE(again.separation.depth, found.depth * (1 + 1e-9));
  EXPECT_GT(again.size, 0);
  ContactFeed fresh({bodies.probe, bodies.fixed}, Method::pdg);
  const Separation poor = fresh.reset(deep, nothing_to_search_with()).separation;
  EXPECT_TRUE(poor.status == Status::failed || poor.depth > found.depth * (1 + 1e-6))
      << "else this test could not fail: " << poor.depth << ' ' << found.depth;
}

TEST(ContactFeed, follows_the_device_as_the_coherent_solver_does) {
  const TwoRings bodies;
  ContactFeed feed({bodies.probe, bodies.fixed}, Method::pdg);
  CoherentSolver solver({bodies.probe, bodies.fixed});
  feed.reset(path(0), {});
  solver.reset(path(0));
  std::uint64_t jumps = 0;
  for (std::uint64_t i = 1; i <= 100; ++i) {
    const Pose X = path(double(i) / 100);
    const LocalContacts& contacts = feed.refresh(X, i, 1e-3 * double(i), {.steps = 20});
    const Separation& want = solver.tick(X, {.steps = 20});
    jumps += want.jumped;
    ASSERT_EQ(contacts.separation.status, want.status);
    EXPECT_EQ(contacts.separation.separated.p, want.separated.p);
    EXPECT_EQ(contacts.separation.depth, want.depth);
    EXPECT_EQ(contacts.jumps, jumps);
    EXPECT_EQ(contacts.tick, i);
    EXPECT_EQ(contacts.time, 1e-3 * double(i));
  }
  EXPECT_EQ(feed.contacts().separation.status, Status::penetrating);
}

TEST(ContactFeed, rows_keep_the_separated_pose_and_begin_with_what_holds_it) {
  const TwoRings bodies;
  ContactFeed feed({bodies.probe, bodies.fixed}, Method::pdg);
  feed.reset(path(0), {});
  int held = 0;
  for (int i = 1; i <= 100; ++i) {
    const LocalContacts& contacts = feed.refresh(path(i / 100.0), 0, 0, {});
    const Separation& s = contacts.separation;
    ASSERT_GE(contacts.size, s.contacts.size);
    for (int r = 0; r < contacts.size; ++r) {
      const LocalContact& row = contacts.rows[static_cast<std::size_t>(r)];
      const double gap = row.normal.dot(s.separated * row.on_probe - row.on_fixed);
      EXPECT_GE(gap, row.least_gap - 1e-12);
      EXPECT_NEAR(row.normal.norm(), 1, 1e-12);
      if (r >= s.contacts.size) continue;
      EXPECT_LT((s.separated * row.on_probe - s.contacts[r].on_probe).norm(), 1e-12);
      ++held;
    }
  }
  EXPECT_GT(held, 50);
}

/// Of 50 ticks, in how many the rows have a reach, and how many pairs are within it in all.
struct Reached {
  int ticks = 0, pairs = 0;
};
Reached expect_rows_of_all_within_reach(const Budget& of_rows) {
  const TwoRings bodies;
  std::vector<NearPair> pairs(4096);
  Reached out;
  ContactFeed feed({bodies.probe, bodies.fixed}, Method::pdg);
  feed.reset(path(0), {});
  for (int i = 0; i <= 50; ++i) {
    const LocalContacts& contacts = feed.refresh(path(i / 50.0), 0, 0, {}, of_rows);
    if (!(contacts.reach > 0)) continue;
    ++out.ticks;
    const Transform X(contacts.separation.separated);
    const NearPairs all = near_pairs(*bodies.probe, *bodies.fixed, X, contacts.reach, pairs);
    EXPECT_EQ(all.reach, contacts.reach);
    // A step of half the reach (as a translation) that every row allows opens every pair.
    for (std::size_t p = 0; p < all.count; ++p) {
      const Vec3 step = -0.5 * contacts.reach * pairs[p].normal;
      if (pairs[p].gap > 0.45 * contacts.reach) continue;  // the step does not close it
      double worst = 0;
      for (int r = 0; r < contacts.size; ++r) {
        const LocalContact& row = contacts.rows[static_cast<std::size_t>(r)];
        const double gap = row.normal.dot(X * row.on_probe + step - row.on_fixed);
        worst = std::min(worst, gap - row.least_gap);
      }
      EXPECT_LT(worst, 0) << "a step straight into the other body that no row forbids";
      ++out.pairs;
    }
  }
  return out;
}

TEST(ContactFeed, nothing_nearer_than_the_reach_is_without_a_row) {
  const Reached found = expect_rows_of_all_within_reach({});
  EXPECT_EQ(found.ticks, 51);
  EXPECT_GT(found.pairs, 100);
}

// No look at the bodies fits into so little work.
TEST(ContactFeed, what_has_no_time_for_a_look_has_the_rows_of_the_solver) {
  const Reached found = expect_rows_of_all_within_reach({.work = 20});
  EXPECT_GT(found.ticks, 25);
  EXPECT_GT(found.pairs, 20);
}

TEST(ContactFeed, a_pose_that_is_none_gives_no_rows_and_the_next_one_works) {
  const TwoRings bodies;
  ContactFeed feed({bodies.probe, bodies.fixed}, Method::pdg);
  feed.reset(path(0), {});
  Pose bad = path(0.1);
  bad.p.x() = std::numeric_limits<double>::quiet_NaN();
  const LocalContacts& contacts = feed.refresh(bad, 1, 0, {});
  EXPECT_EQ(contacts.separation.status, Status::failed);
  EXPECT_EQ(contacts.size, 0);
  EXPECT_NE(feed.refresh(path(0.1), 2, 0, {}).separation.status, Status::failed);
}

}  // namespace
}  // namespace sonde
