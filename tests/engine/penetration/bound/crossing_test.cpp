// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/crossing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/sonde.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

Pose at(const Vec3& p) { return {Quat::Identity(), p}; }

/// A sheet of 2 · cells² triangles: |x| ≤ x, |y| ≤ y, turned so that its x and y are columns of R.
PolygonSoup sheet(double x, double y, int cells, const Mat3& R) {
  PolygonSoup out;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j)
      out.points.push_back(R * Vec3((2.0 * i / cells - 1) * x, (2.0 * j / cells - 1) * y, 0));
  const auto corner = [&](int i, int j) { return static_cast<std::size_t>(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const std::size_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                        d = corner(i, j + 1);
      if ((i + j) % 2 == 0) {
        out.polygons.push_back({a, b, c});
        out.polygons.push_back({a, c, d});
      } else {
        out.polygons.push_back({a, d, b});  // the other way round: orders of corners do not count
        out.polygons.push_back({b, c, d});
      }
    }
  return out;
}
const Mat3 flat = Mat3::Identity();
const Mat3 upright = (Mat3() << 0, 0, 1, 0, 1, 0, 1, 0, 0).finished();  // x is up

/// A tube without lids about z.
PolygonSoup tube(double radius, double half, int sides) {
  PolygonSoup out;
  for (const double z : {-half, half})
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      out.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  const auto n = static_cast<std::size_t>(sides);
  for (std::size_t i = 0; i < n; ++i) {
    out.polygons.push_back({i, (i + 1) % n, n + (i + 1) % n});
    out.polygons.push_back({i, n + (i + 1) % n, n + i});
  }
  return out;
}

double bound(const Body& probe, const Body& fixed, const Pose& X_FM, bool translations) {
  return depth_lower_bound(probe, fixed, X_FM, {}, {.translations = translations}).value_or(-1);
}

// By hand: a flat sheet and an upright one that cross like an X must be displaced until an edge of
// one comes to the other, or past it along the line in which they cross: PD_t. A turn can only
// help.
TEST(Crossing, of_two_sheets_is_what_a_translation_needs) {
  struct Case {
    double x, y, z, width;  // half sizes: flat x by y, upright z by width
    Vec3 p;
  };
  for (const Case& c :
       {Case{1, 1, 1, 1, {0, 0, 0}}, Case{1, 1, 1, 1, {0.3, 0.1, -0.2}},
        Case{2, 0.7, 0.4, 0.8, {0.5, 0.2, 0.1}},
        Case{0.02, 0.05, 0.03, 0.04, {-0.011, 0.01, 0.003}}, Case{30, 80, 90, 50, {7, 20, -60}}})
    for (const int cells : {1, 4, 9}) {
      const auto probe = test::body(sheet(c.x, c.y, cells, flat)),
                 fixed = test::body(sheet(c.z, c.width, cells + 1, upright));
      const double out = std::min(
          {c.x - std::abs(c.p.x()), c.z - std::abs(c.p.z()), c.y + c.width - std::abs(c.p.y())});
      const double straight = bound(*probe, *fixed, at(c.p), true),
                   turned = bound(*probe, *fixed, at(c.p), false);
      EXPECT_LE(straight, out) << cells;
      EXPECT_GT(straight, 0.75 * out) << cells;
      EXPECT_LE(turned, straight) << cells;
      EXPECT_GT(turned, 0.3 * out) << cells;
    }
}

// By hand, as above: half of either thickness more. Inside points prove no more than a thickness.
TEST(Crossing, of_two_thin_plates_is_that_of_sheets) {
  for (const double h : {1e-6, 1e-3, 0.02}) {
    const auto probe = test::body(test::box({2, 1.6, h})),
               fixed = test::body(test::box({h, 1.4, 1}));
    ASSERT_TRUE(probe->solid && fixed->solid);
    const double out = 0.5 + h / 2;
    const double straight = bound(*probe, *fixed, at({0.2, 0.1, 0}), true);
    EXPECT_LE(straight, out) << h;
    EXPECT_GT(straight, 0.9 * (0.5 - h)) << h;
    EXPECT_GT(bound(*probe, *fixed, at({0.2, 0.1, 0}), false), 0.3 * out) << h;
  }
}

// By hand: a tube through the middle of a sheet with room around it leaves lengthways, or past the
// rim: both need more than it takes to bring the tube's wall to the rim.
TEST(Crossing, of_a_tube_through_a_sheet) {
  for (const int sides : {5, 24, 60}) {
    const auto probe = test::body(tube(0.2, 1, sides)), fixed = test::body(sheet(1, 1.5, 3, flat));
    ASSERT_FALSE(probe->solid || fixed->solid);
    const double straight = bound(*probe, *fixed, at({0.1, 0, 0.3}), true);
    EXPECT_LE(straight, 0.7) << sides;  // lengthways
    EXPECT_GT(straight, 0.6) << sides;
    EXPECT_GT(bound(*probe, *fixed, at({0.1, 0, 0.3}), false), 0.2) << sides;
  }
}

// By hand: a plate of 0.1 m made thinner by 0.02 m on each side, through a sheet: its faces are
// 0.06 m apart and end 0.02 m sooner.
TEST(Crossing, of_a_body_offset_is_that_of_what_touches) {
  const auto plate = test::body(test::box({2, 2, 0.1})),
             fixed = test::body(sheet(1.5, 1.5, 3, upright));
  for (const double by : {-0.02, 0.02}) {
    const auto probe = offset_body(*plate, by);
    const double out = 0.6 + by;  // sideways past the sheet's plane
    const double straight = bound(*probe, *fixed, at({0.4, 0.1, 0}), true);
    EXPECT_LE(straight, out) << by;
    EXPECT_GT(straight, 0.85 * out) << by;
  }
}

// A curve that ends at the patch, or pierces it twice, proves nothing.
TEST(Crossing, none_where_surfaces_only_touch_or_lie_in_one_plane) {
  const auto one = test::body(sheet(1, 1, 3, flat)), other = test::body(sheet(1, 1, 4, upright));
  EXPECT_EQ(bound(*one, *one, at({0.1, 0.2, 0}), true), -1);
  EXPECT_EQ(bound(*one, *other, at({0, 0, 3}), true), -1);
  EXPECT_LE(bound(*one, *other, at({0, 0, 1}), true), 0);
  EXPECT_LE(bound(*one, *other, at({1, 0, 0.2}), true), 1e-12);
}

TEST(Crossing, says_where_it_is_and_what_it_stands_for) {
  const auto probe = test::body(sheet(1, 1, 2, flat)), fixed = test::body(sheet(1, 1, 2, upright));
  CrossingSearch search{.reach = 4, .price = [](const Vec3& x) { return 1 + x.squaredNorm(); }};
  const Crossing found = best_crossing(*probe, *fixed, Transform(at({0.2, 0, 0})), search);
  EXPECT_LE(found.bound * found.bound, found.depth * found.depth);
  EXPECT_GT(found.bound, 0.5 * found.depth);
  EXPECT_NEAR(found.at.x(), 0, 1e-12);  // on both
  EXPECT_NEAR(found.at.z(), 0, 1e-12);
  search.beat = found.bound;
  EXPECT_EQ(best_crossing(*probe, *fixed, Transform(at({0.2, 0, 0})), search).bound, 0);
  search.beat = 0, search.work = 0;
  EXPECT_LE(best_crossing(*probe, *fixed, Transform(at({0.2, 0, 0})), search).bound, found.bound);
}

// Reference: free poses found at random, with exact predicates; each is an upper bound.
void compare_crossings(std::uint64_t seed, int poses) {
  std::mt19937_64 random(seed);
  using Made = std::pair<PolygonSoup, PolygonSoup>;
  for (const auto& [a, b] :
       {Made{sheet(0.1, 0.2, 3, flat), sheet(0.15, 0.1, 5, upright)},
        Made{tube(0.1, 0.2, 17), sheet(0.2, 0.2, 2, flat)},
        Made{tube(0.1, 0.1, 9), tube(0.12, 0.15, 20)},
        Made{test::box({0.3, 0.2, 1e-4}), tube(0.1, 0.2, 12)},
        Made{test::random_soup(random, 12, 0.2), sheet(0.15, 0.15, 4, upright)}}) {
    const auto probe = test::body(a, Model::surface), fixed = test::body(b);
    int compared = 0, positive = 0;
    double closest = 0;
    for (int i = 0; i < poses; ++i) {
      const Pose O = test::random_pose(random, *probe, *fixed, 0.6);
      if (!overlap(*probe, *fixed, Transform(O), Doubt::exact)) continue;
      const double proved = bound(*probe, *fixed, O, false),
                   straight = bound(*probe, *fixed, O, true);
      positive += proved > 0;
      const Chart chart(probe->mass, O);
      for (int k = 0; k < 200; ++k) {
        Vec6 y;
        for (int m = 0; m < 6; ++m) y[m] = test::uniform(random, -1, 1);
        if (k % 2 == 0) y.head<3>().setZero();  // a translation
        y *= test::uniform(random, 0.01, 0.7) * probe->mass.radius / y.norm();
        if (chart.v(y).norm() > 0.99) continue;
        if (overlap(*probe, *fixed, Transform(chart.pose(y)), Doubt::exact)) continue;
        EXPECT_LE(proved, y.norm());
        if (k % 2 == 0) {
          EXPECT_LE(straight, y.norm());
        }
        closest = std::max(closest, proved / y.norm());
        ++compared;
      }
    }
    EXPECT_GT(compared, 50);
    EXPECT_GT(positive, poses / 4);
    EXPECT_GT(closest, 0.1);  // else the comparison would show little
  }
}

TEST(Crossing, is_never_above_a_free_pose) { compare_crossings(1, 40); }
TEST(Crossing, Full_is_never_above_a_free_pose_of_many) {
  for (std::uint64_t seed = 2; seed < 8; ++seed) compare_crossings(seed, 150);
}

}  // namespace
}  // namespace sonde
