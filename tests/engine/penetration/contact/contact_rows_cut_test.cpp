// SPDX-License-Identifier: GPL-3.0-or-later
// ContactRows::add_cuts: what of a step is in the way, by a list and by the trees.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "engine/body/body.hpp"
#include "engine/penetration/contact/contact_rows.hpp"
#include "tests/engine/penetration/contact/findings.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::by_list;
using test::by_trees;

/// A cube `gap` over a plate, gathered so short-sightedly that there is no row, or with rows.
struct OverAPlate {
  std::shared_ptr<const Body> cube = test::body(test::box({0.1, 0.1, 0.1}));
  std::shared_ptr<const Body> plate = test::body(test::box({1, 1, 1}));
  Chart chart{cube->mass, {Quat::Identity(), Vec3(0.02, 0.03, 0.53)}};
  ContactRows rows;
  Vec6 y = Vec6::Zero();

  OverAPlate(double gap, double reach, const ContactRows::Finding& finding)
      : rows(*cube, *plate, Method::pdg, finding) {
    y[5] = 0.02 + gap;
    rows.gather(chart, y, reach, 0);
  }
  Motion moved(const Vec3& by) const {
    Vec6 to = y;
    to.tail<3>() += by;
    return {chart, y, to};
  }
  bool has_corners_of_the_cube() const {
    for (const double x : {-0.05, 0.05})
      for (const double z : {-0.05, 0.05}) {
        bool found = false;
        for (int k = 0; k < rows.size(); ++k)
          found = found ||
                  (rows.contact(k).on_probe - Vec3(0.02 + x, 0.03 + z, 0.48 + y[5])).norm() < 1e-9;
        if (!found) return false;
      }
    return true;
  }
};

// By hand: up and along the plate there is nothing in the way.
TEST(ContactRows, a_cut_says_clear_where_nothing_is_in_the_way) {
  Effort unlimited;
  for (const auto& finding : {by_list, by_trees})
    for (const double gap : {1e-6, 1e-5, 1e-4}) {
      OverAPlate over(gap, 0.5 * gap, finding);
      for (const Vec3& by : {Vec3(0, 0, 1e-5), Vec3(1e-4, -1e-4, 0), Vec3(1e-4, 0, -0.04 * gap)}) {
        const ContactRows::PathCheck look =
            over.rows.add_cuts(over.chart, over.y, over.moved(by), 0.9 * gap, unlimited);
        EXPECT_TRUE(look.clear) << gap;
        EXPECT_FALSE(look.news) << gap;
        EXPECT_EQ(look.lost, 0) << gap;
        EXPECT_EQ(over.rows.size(), 0) << gap;
      }
    }
}

// Closed form: what a plane takes from its gap, or from the margin where the gap is larger. By the
// trees nothing is known of the depth: as much is lost as there was.
TEST(ContactRows, what_a_cut_loses_to_a_plane) {
  Effort unlimited;
  constexpr double margin = 1e-5;
  for (const auto& finding : {by_list, by_trees})
    for (const double gap : {1e-6, 5e-6, 2e-5, 1e-4})
      for (const double share : {0.3, 0.7, 1.1, 1.5}) {
        OverAPlate over(gap, 0.5 * gap, finding);
        const double sunk = share * gap, held = std::min(gap, margin);
        const ContactRows::PathCheck look =
            over.rows.add_cuts(over.chart, over.y, over.moved({0, 0, -sunk}), margin, unlimited);
        const bool in_the_way = gap - sunk < 0.95 * held;
        EXPECT_EQ(look.clear, !in_the_way) << gap << " " << share;
        EXPECT_EQ(look.news, in_the_way) << gap << " " << share;
        const double left = finding.keeps_lists ? gap - sunk : std::max(0.0, gap - sunk);
        EXPECT_NEAR(look.lost, in_the_way ? held - left : 0, 1e-12) << gap << " " << share;
      }
}

// By hand: the corners of the cube, which keep it from sinking and tipping.
TEST(ContactRows, a_cut_adds_rows_of_what_is_in_the_way) {
  Effort unlimited;
  constexpr double gap = 1e-4, margin = 1e-6;
  for (const auto& finding : {by_list, by_trees}) {
    OverAPlate over(gap, 0.5 * gap, finding);
    ASSERT_EQ(over.rows.size(), 0);
    EXPECT_EQ(over.rows.solve(margin, ContactRows::SmallGaps::keep).y.norm(), 0);
    const Motion down = over.moved({0, 0, -0.001});
    EXPECT_TRUE(over.rows.add_cuts(over.chart, over.y, down, margin, unlimited).news);
    EXPECT_TRUE(over.has_corners_of_the_cube());
    const LeastDistance nearest = over.rows.solve(margin, ContactRows::SmallGaps::keep);
    EXPECT_NEAR(nearest.y.norm(), 0.02 + margin, 0.1 * margin);
    EXPECT_NEAR(nearest.y[5], 0.02 + margin, 0.1 * margin);
    // It is still in the way, and no news.
    const ContactRows::PathCheck again =
        over.rows.add_cuts(over.chart, over.y, down, margin, unlimited);
    EXPECT_FALSE(again.clear);
    EXPECT_FALSE(again.news);
    // The way to the least point is clear.
    EXPECT_TRUE(
        over.rows
            .add_cuts(over.chart, over.y, {over.chart, over.y, nearest.y}, 0.5 * margin, unlimited)
            .clear);
  }
}

TEST(ContactRows, what_cut_a_step_short_is_looked_at_again) {
  Effort unlimited;
  constexpr double gap = 1e-4;
  OverAPlate over(gap, 0.5 * gap, {.most_pairs = 2});
  over.rows.add_cuts(over.chart, over.y, over.moved({0, 0, -0.001}), 1e-6, unlimited);
  ASSERT_TRUE(over.has_corners_of_the_cube());
  over.rows.gather(over.chart, over.y, 2 * gap, 4 * gap);
  EXPECT_TRUE(over.has_corners_of_the_cube());
  over.rows.forget();
  over.rows.gather(over.chart, over.y, 0.5 * gap, 0);
  EXPECT_EQ(over.rows.size(), 0);
}

/// Loose triangles all round the origin, at 0.1 m, that face it.
PolygonSoup cage(int count) {
  PolygonSoup out;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, angle = 2.399963 * i;
    const double r = std::sqrt(1 - z * z);
    const Vec3 n(r * std::cos(angle), r * std::sin(angle), z);
    const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
    const auto k = out.points.size();
    for (const Vec3& x : {u, Vec3(-0.5 * u + 0.8 * v), Vec3(-0.5 * u - 0.8 * v)})
      out.points.push_back(0.1 * n + 0.003 * x);
    out.polygons.push_back({k, k + 1, k + 2});
  }
  return out;
}

// By hand: each triangle of the cage keeps the probe off in a direction of its own, and there are
// more of them than rows.
TEST(ContactRows, when_there_is_no_room_for_a_row_the_look_is_not_clear) {
  const auto probe = test::body(test::box({0.01, 0.01, 0.01}));
  const auto fixed = test::body(cage(600));
  const Chart chart{probe->mass, {}};
  ContactRows rows(*probe, *fixed, Method::pdg, by_trees);
  const Vec6 y = Vec6::Zero();
  rows.gather(chart, y, 1e-3, 0);
  ASSERT_EQ(rows.size(), 0);
  Effort unlimited;
  std::mt19937_64 random(5);
  int unseen = 0;
  for (int i = 0; i < 400; ++i) {
    Vec6 to = y;
    to.tail<3>() = 0.0955 * test::random_in_ball(random, 1).normalized();
    const bool was_full = rows.is_full();
    const ContactRows::PathCheck look =
        rows.add_cuts(chart, y, Motion(chart, y, to), 1e-3, unlimited);
    EXPECT_EQ(look.clear, look.lost == 0);
    EXPECT_FALSE(look.news && was_full);
    unseen += was_full && !look.clear;
  }
  EXPECT_EQ(rows.size(), ContactRows::capacity);
  EXPECT_GT(unseen, 10);
}

}  // namespace
}  // namespace sonde
