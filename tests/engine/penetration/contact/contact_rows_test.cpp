// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/contact_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/penetration/descent/descent.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/engine/penetration/contact/findings.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

using test::by_list;
using test::by_trees;

struct Gathered {
  Chart chart;
  Vec6 y;
  double reach;
};

/// A free y on the way to a device pose that overlaps, stopped so near to contact that there are
/// rows.
Gathered free_place(std::mt19937_64& random, const test::BodyPair& pair, double turn) {
  const double r = pair.a->mass.radius;
  for (;;) {
    const Chart chart(pair.a->mass, test::random_pose(random, *pair.a, *pair.b, 0.8));
    Vec6 y;
    y.head<3>() =
        2 * pair.a->mass.inertia.cwiseSqrt().cwiseProduct(test::random_in_ball(random, turn));
    y.tail<3>() = test::random_in_ball(random, r);
    if (test::any_pair_meets(*pair.a, *pair.b, Transform(chart.pose(y)))) continue;
    const double reach = 0.05 * r * test::uniform(random, 0.1, 1);
    const double clearance = reach * test::uniform(random, 0.01, 0.5);
    const Sweep s = sweep(*pair.a, *pair.b, Motion(chart, y, Vec6::Zero()), clearance);
    if (!s.hit) continue;
    return {chart, (1 - s.free_until) * y, reach};
  }
}

std::vector<test::BodyPair> pairs_near_origin(std::uint64_t seed) {
  auto all = test::body_pairs(seed);
  all.pop_back();  // far from the origin there is nothing new to rows
  return all;
}

// Reference: every pair of triangles. One within reach must be kept apart by some row: a direction
// that separates it as well, to first order, at the gap of the row at least.
TEST(ContactRows, every_near_pair_is_kept_apart_by_some_row) {
  std::mt19937_64 random(1);
  for (const auto& pair : pairs_near_origin(71)) {
    ContactRows rows(*pair.a, *pair.b, Method::pdg, {});
    int near = 0;
    for (int i = 0; i < 60; ++i) {
      const Gathered g = free_place(random, pair, 0.6);
      rows.gather(g.chart, g.y, g.reach, 0);
      EXPECT_LE(rows.reach(), g.reach);
      const double size = pair.a->mass.radius + pair.b->mass.radius;
      double smallest = rows.reach();
      const Transform X(g.chart.pose(g.y));
      const auto tb = test::placed_triangles(*pair.b, {});
      for (const Corners& a : test::placed_triangles(*pair.a, X))
        for (const Corners& b : tb) {
          const double distance = closest_points(a, b).distance;
          if (distance >= rows.reach() || !(distance > 0)) continue;
          smallest = std::min(smallest, distance);
          ++near;
          bool apart = false;
          for (int k = 0; k < rows.size() && !apart; ++k) {
            const Contact c = rows.contact(k);
            // Rows of normals within 1e-6 count as one.
            apart = gap_along(c.normal, a, b) >= c.gap * (1 - 1e-6) - 2e-6 * size;
          }
          EXPECT_TRUE(apart || rows.size() >= 128) << pair.name << i;
        }
      EXPECT_NEAR(rows.smallest_gap(), smallest, 1e-9 * size) << pair.name;
      for (int k = 0; k < rows.size(); ++k) {
        const Contact c = rows.contact(k);
        EXPECT_NEAR(c.normal.norm(), 1, 1e-12);
        EXPECT_GE(c.gap, 0);
      }
    }
    EXPECT_GT(near, 50) << pair.name;
  }
}

// The place itself satisfies its rows, so the least point is no further; and it keeps the rows, as
// recomputed here from the contacts.
TEST(ContactRows, the_solution_is_nearer_and_keeps_the_rows) {
  std::mt19937_64 random(2);
  for (const auto& pair : pairs_near_origin(72))
    for (const Method method : {Method::pdg, Method::pdt}) {
      ContactRows rows(*pair.a, *pair.b, method, {});
      int held = 0;
      for (int i = 0; i < 60; ++i) {
        const Gathered g = free_place(random, pair, method == Method::pdt ? 0 : 0.6);
        const double margin = 1e-3 * g.reach, r = pair.a->mass.radius;
        rows.gather(g.chart, g.y, g.reach, 4 * margin);
        const LeastDistance nearest = rows.solve(margin, ContactRows::SmallGaps::keep);
        ASSERT_TRUE(nearest.feasible) << pair.name;
        EXPECT_LE(nearest.y.norm(), g.y.norm() * (1 + 1e-9) + 0.1 * margin) << pair.name;
        if (method == Method::pdt) {
          EXPECT_EQ(nearest.y.head<3>().norm(), 0);
        }
        for (int k = 0; k < rows.size(); ++k) {
          const Contact c = rows.contact(k);
          Vec6 row = g.chart.row(g.y, c.on_probe, c.normal);
          if (method == Method::pdt) row.head<3>().setZero();
          const double kept = c.gap + row.dot(nearest.y - g.y);
          EXPECT_GE(kept, std::min(c.gap, margin) - 0.05 * margin - 1e-9 * r) << pair.name;
        }
        held += nearest.active_count > 0;
        // Opened: gaps smaller than a margin wider than them are widened to it.
        const double wide = 2 * rows.smallest_gap();
        const LeastDistance opened = rows.solve(wide, ContactRows::SmallGaps::widen);
        if (!opened.feasible) continue;
        for (int k = 0; k < rows.size(); ++k) {
          const Contact c = rows.contact(k);
          Vec6 row = g.chart.row(g.y, c.on_probe, c.normal);
          if (method == Method::pdt) row.head<3>().setZero();
          EXPECT_GE(c.gap + row.dot(opened.y - g.y), 0.95 * wide - 1e-9 * r) << pair.name;
        }
      }
      EXPECT_GT(held, 10) << pair.name;
    }
}

// Whether by the list of the last gather or by the trees: what it calls free is, by exact
// predicates on all pairs.
TEST(ContactRows, sweeps_are_conservative) {
  std::mt19937_64 random(3);
  for (const auto& pair : pairs_near_origin(73)) {
    ContactRows rows(*pair.a, *pair.b, Method::pdg, {});
    int hits = 0, misses = 0;
    for (int i = 0; i < 40; ++i) {
      const Gathered g = free_place(random, pair, 0.6);
      rows.gather(g.chart, g.y, 0.2 * g.reach, 0);
      for (const double length : {0.2, 2.0, 30.0}) {
        Vec6 way;
        for (int k = 0; k < 6; ++k) way[k] = test::uniform(random, -1, 1);
        for (int k = 0; k < 3; ++k)
          if (!(pair.a->mass.inertia[k] > 0)) way[k] = 0;
        const Vec6 to = g.y + length * g.reach * way.normalized();
        if (g.chart.v(to).norm() > 0.95) continue;
        const Motion motion(g.chart, g.y, to);
        Effort unlimited;
        const Sweep s = rows.sweep_along(motion, 1e-6 * g.reach, unlimited);
        for (const double at : {0.3, 0.7, 0.95, 0.9999, 1.0})
          EXPECT_FALSE(test::any_pair_meets(*pair.a, *pair.b, motion.at(at * s.free_until)))
              << pair.name;
        (s.hit ? hits : misses)++;
      }
    }
    EXPECT_GT(hits, 5) << pair.name;
    EXPECT_GT(misses, 20) << pair.name;
  }
}

// By hand: a cube a little over a plate gives the four corners of its lower face, so that it can
// neither sink nor tip.
TEST(ContactRows, a_cube_over_a_plate_stands_on_its_corners) {
  const auto cube = test::body(test::box({0.1, 0.1, 0.1})),
             plate = test::body(test::box({1, 1, 1}));
  const Chart chart(cube->mass, {Quat::Identity(), Vec3(0.02, 0.03, 0.53)});
  Vec6 y = Vec6::Zero();
  y[5] = 0.02 + 1e-6;  // the gap
  ContactRows rows(*cube, *plate, Method::pdg, {});
  rows.gather(chart, y, 1e-4, 4e-6);
  for (const double x : {-0.05, 0.05})
    for (const double z : {-0.05, 0.05}) {
      bool found = false;
      for (int k = 0; k < rows.size(); ++k)
        found =
            found || (rows.contact(k).on_probe - Vec3(0.02 + x, 0.03 + z, 0.500001)).norm() < 1e-9;
      EXPECT_TRUE(found) << x << " " << z;
    }
  const LeastDistance nearest = rows.solve(1e-7, ContactRows::SmallGaps::keep);
  EXPECT_NEAR(nearest.y.norm(), 0.02 + 1e-7, 1e-8);
  EXPECT_LT(nearest.y.head<5>().norm(), 1e-9);
}

// Reference: closest_points of all pairs at both ends of the step.
TEST(ContactRows, a_cut_agrees_with_all_pairs) {
  std::mt19937_64 random(5);
  for (const auto& pair : pairs_near_origin(75))
    for (const auto& finding : {by_list, by_trees}) {
      ContactRows rows(*pair.a, *pair.b, Method::pdg, finding);
      int clear = 0, blocked = 0;
      for (int i = 0; i < 40; ++i) {
        const Gathered g = free_place(random, pair, 0.6);
        const double margin = 0.3 * g.reach, rounding = 1e-9 * pair.a->mass.radius;
        rows.gather(g.chart, g.y, test::uniform(random, 0.05, 1) * g.reach, 0);
        Vec6 to = g.y;
        for (int k = 0; k < 6; ++k)
          if (k > 2 || pair.a->mass.inertia[k] > 0)
            to[k] += g.reach * test::uniform(random, -0.3, 0.3);
        const Motion motion(g.chart, g.y, to);
        const auto here = test::placed_triangles(*pair.a, motion.at(0)),
                   there = test::placed_triangles(*pair.a, motion.at(1)),
                   fixed = test::placed_triangles(*pair.b, {});
        int near = 0, in_the_way = 0, in_doubt = 0;
        double lost = 0;
        for (std::size_t a = 0; a < here.size(); ++a)
          for (const Corners& b : fixed) {
            const double left = closest_points(there[a], b).distance;
            if (left > 0.95 * margin + rounding) continue;
            ++near;
            const double had = std::min(margin, closest_points(here[a], b).distance);
            in_the_way += left < 0.95 * had - rounding;
            in_doubt += std::abs(left - 0.95 * had) <= rounding;
            if (left < 0.95 * had - rounding) lost = std::max(lost, had - left);
          }
        if (near > 16 || in_doubt > 0) continue;  // there is room for 16
        Effort unlimited;
        const int before = rows.size();
        const ContactRows::PathCheck look = rows.add_cuts(g.chart, g.y, motion, margin, unlimited);
        EXPECT_EQ(look.clear, in_the_way == 0) << pair.name << i;
        EXPECT_EQ(look.news, rows.size() > before) << pair.name << i;
        EXPECT_GE(look.lost, lost - rounding) << pair.name << i;
        (look.clear ? clear : blocked)++;
      }
      EXPECT_GT(clear, 3) << pair.name;
      EXPECT_GT(blocked, 3) << pair.name;
    }
}

/// Near the rim of the chart, so near to contact that there are rows; none in a few tries.
std::optional<Gathered> place_at_the_rim(std::mt19937_64& random, const test::BodyPair& pair,
                                         double low = 0.87, double high = 0.9499) {
  const double r = pair.a->mass.radius;
  if (!(pair.a->mass.inertia.minCoeff() > 0)) return {};
  for (int i = 0; i < 20; ++i) {
    const Chart chart(pair.a->mass, test::random_pose(random, *pair.a, *pair.b, 0.8));
    const Vec3 v = test::uniform(random, low, high) * test::random_in_ball(random, 1).normalized();
    Vec6 y;
    y.head<3>() = 2 * pair.a->mass.inertia.cwiseSqrt().cwiseProduct(v);
    y.tail<3>() = test::random_in_ball(random, 2 * r);
    if (test::any_pair_meets(*pair.a, *pair.b, Transform(chart.pose(y)))) continue;
    Vec6 to = y;
    to.tail<3>().setZero();
    const Sweep s = sweep(*pair.a, *pair.b, Motion(chart, y, to), 1e-3 * r);
    if (s.hit) return Gathered{chart, y + s.free_until * (to - y), 0.05 * r};
  }
  return {};
}

// Reference: the same problem put together here without the rim, which would lead out of it.
TEST(ContactRows, the_rim_of_the_chart_is_a_row_of_its_own) {
  std::mt19937_64 random(6);
  int solved = 0, would_leave = 0;
  for (const auto& pair : pairs_near_origin(76)) {
    ContactRows rows(*pair.a, *pair.b, Method::pdg, {});
    for (int i = 0; i < 60; ++i) {
      const auto g = place_at_the_rim(random, pair);
      if (!g) continue;
      rows.gather(g->chart, g->y, g->reach, 0);
      const Vec3 outwards = g->chart.v(g->y).normalized();
      for (const double margin : {0.01, 0.2, 1.0}) {
        const double wide = margin * pair.a->mass.radius;
        const LeastDistance nearest = rows.solve(wide, ContactRows::SmallGaps::widen);
        if (!nearest.feasible) continue;
        ++solved;
        // To the tolerance of the problem, which is in the unit of y.
        const double tolerance = 0.05 * wide;
        Vec6 out = Vec6::Zero();
        out.head<3>() = g->chart.in_v(outwards);
        const double rim = Chart::largest_v + tolerance * out.norm();
        EXPECT_LE(out.dot(nearest.y), rim) << pair.name;
        std::vector<HalfSpace> alone;
        for (int k = 0; k < rows.size(); ++k) {
          const Contact c = rows.contact(k);
          const Vec6 row = g->chart.row(g->y, c.on_probe, c.normal);
          alone.push_back({row, row.dot(g->y) - (c.gap - wide)});
        }
        const LeastDistance without = least_distance(alone, tolerance);
        would_leave += without.feasible && out.dot(without.y) > rim;
      }
    }
  }
  EXPECT_GT(solved, 100);
  EXPECT_GT(would_leave, 5);
}

// From starts with some room up to the rim. Where steps went along the rim from where they began,
// other rows did not hold on the way: 12 of 360 descents did not converge.
TEST(ContactRows, steps_that_lead_out_of_the_chart_end_at_its_rim) {
  std::mt19937_64 random(8);
  int runs = 0, converged = 0;
  for (const auto& pair : pairs_near_origin(78)) {
    Descent descent(*pair.a, *pair.b, Method::pdg);
    for (int i = 0; i < 60; ++i) {
      const auto g = place_at_the_rim(random, pair, 0.75, 0.9);
      if (!g) continue;
      descent.forget();
      converged += descent.run(g->chart, g->y, {}, 0, Deadline{}).converged;
      ++runs;
    }
  }
  EXPECT_GT(runs, 300);
  EXPECT_LE(50 * (runs - converged), runs);
}

TEST(ContactRows, descents_stay_in_the_chart) {
  std::mt19937_64 random(7);
  int runs = 0;
  for (const auto& pair : pairs_near_origin(77)) {
    Descent descent(*pair.a, *pair.b, Method::pdg);
    for (int i = 0; i < 20; ++i) {
      const auto g = place_at_the_rim(random, pair);
      if (!g) continue;
      descent.forget();
      const Descent::Outcome out = descent.run(g->chart, g->y, {}, 0, Deadline{});
      EXPECT_LE(g->chart.v(out.y).norm(), Chart::largest_v * (1 + 1e-12)) << pair.name;
      EXPECT_LE(out.y.norm(), g->y.norm() * (1 + 1e-12)) << pair.name;
      ++runs;
    }
  }
  EXPECT_GT(runs, 40);
}

TEST(ContactRows, do_not_allocate) {
  std::mt19937_64 random(4);
  for (const auto& pair : pairs_near_origin(74)) {
    ContactRows rows(*pair.a, *pair.b, Method::pdg, {});
    const Gathered g = free_place(random, pair, 0.5);
    const Motion motion(g.chart, g.y, 0.99 * g.y);
    test::AllocationCounter counter;
    rows.gather(g.chart, g.y, g.reach, 0.1 * g.reach);
    rows.solve(0.01 * g.reach, ContactRows::SmallGaps::keep);
    Effort unlimited;
    rows.sweep_along(motion, 1e-6 * g.reach, unlimited);
    counter.stop();
    EXPECT_EQ(counter.allocations(), 0u) << pair.name;
  }
}

}  // namespace
}  // namespace sonde
