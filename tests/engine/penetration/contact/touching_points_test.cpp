// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/touching_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

const Vec3 upwards = Vec3::UnitZ();
const Corners wide_floor{Vec3(-4, -4, 0), Vec3(4, -4, 0), Vec3(0, 4, 0)};

TEST(TouchingPoints, a_corner_on_a_face_is_one_point) {
  const Corners tip{Vec3(1, 0, 3), Vec3(0.25, -0.5, 0.125), Vec3(-1, 0, 3)};
  const TouchingPoints found = touching_points(tip, wide_floor, upwards, 1e-9);
  ASSERT_EQ(found.size, 1);
  const Contact& c = *found.begin();
  EXPECT_EQ(c.on_probe, tip[1]);
  EXPECT_LT((c.on_fixed - Vec3(0.25, -0.5, 0)).norm(), 1e-15);
  EXPECT_EQ(c.normal, upwards);
  EXPECT_NEAR(c.gap, 0.125, 1e-15);
  EXPECT_EQ(c.multiplier, 0);
  // The other way round.
  const TouchingPoints turned = touching_points(wide_floor, tip, -upwards, 1e-9);
  ASSERT_EQ(turned.size, 1);
  EXPECT_EQ(turned.begin()->on_fixed, tip[1]);
  EXPECT_LT((turned.begin()->on_probe - Vec3(0.25, -0.5, 0)).norm(), 1e-15);
  EXPECT_NEAR(turned.begin()->gap, 0.125, 1e-15);
}

// Reference: by hand.
TEST(TouchingPoints, an_edge_on_a_face_has_its_ends_or_where_it_leaves_the_face) {
  const Corners within{Vec3(-1, 0, 0), Vec3(1, -1, 0), Vec3(0, 0, 2)};
  TouchingPoints found = touching_points(within, wide_floor, upwards, 1e-9);
  ASSERT_EQ(found.size, 2);
  EXPECT_EQ(found.items[0].on_probe, within[0]);
  EXPECT_EQ(found.items[1].on_probe, within[1]);
  // At y = 0, the sides of the floor are at x = ±2.
  const Corners across{Vec3(-1, 0, 0), Vec3(5, 0, 0), Vec3(0, 0, 2)};
  found = touching_points(across, wide_floor, upwards, 1e-9);
  ASSERT_EQ(found.size, 2);
  EXPECT_EQ(found.items[0].on_probe, across[0]);
  EXPECT_LT((found.items[1].on_probe - Vec3(2, 0, 0)).norm(), 1e-14);
  EXPECT_LT((found.items[1].on_fixed - Vec3(2, 0, 0)).norm(), 1e-14);
}

// Reference: by hand.
TEST(TouchingPoints, edges_have_their_crossing_or_the_ends_of_what_they_share) {
  const Corners ridge{Vec3(-2, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, -3)};
  const Corners crossing{Vec3(0.5, -1, 0.25), Vec3(1.5, 1, 0.25), Vec3(0, 0, 4)};
  TouchingPoints found = touching_points(crossing, ridge, upwards, 1e-9);
  ASSERT_EQ(found.size, 1);
  EXPECT_LT((found.begin()->on_probe - Vec3(1, 0, 0.25)).norm(), 1e-15);
  EXPECT_LT((found.begin()->on_fixed - Vec3(1, 0, 0)).norm(), 1e-15);
  EXPECT_EQ(found.begin()->gap, 0.25);
  const Corners along{Vec3(-3, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 4)};
  found = touching_points(along, ridge, upwards, 1e-9);
  ASSERT_EQ(found.size, 2);
  EXPECT_EQ(found.items[0].on_probe, Vec3(1, 0, 0));  // its own end, over the ridge
  EXPECT_EQ(found.items[1].on_fixed, Vec3(-2, 0, 0));
  EXPECT_LT((found.items[1].on_probe - Vec3(-2, 0, 0)).norm(), 1e-15);
}

TEST(TouchingPoints, apart_as_seen_along_the_normal_are_the_lowest_and_the_highest_corner) {
  const Corners ridge{Vec3(-2, 0, 0), Vec3(2, 0, -1), Vec3(0, 0, -3)};
  const Corners beside{Vec3(5, 1, 9), Vec3(5, 2, 1), Vec3(5, 0, 1.5)};
  const TouchingPoints found = touching_points(beside, ridge, upwards, 1e-9);
  ASSERT_EQ(found.size, 1);
  EXPECT_EQ(found.begin()->on_probe, beside[1]);
  EXPECT_EQ(found.begin()->on_fixed, ridge[0]);
  EXPECT_EQ(found.begin()->gap, 1);
}

TEST(TouchingPoints, what_is_higher_than_the_slack_is_no_part_of_the_feature) {
  for (const double tilt : {1e-4, 1e-2}) {
    const Corners edge{Vec3(-1, 0, 0), Vec3(1, 0, tilt), Vec3(0, 0, 2)};
    EXPECT_EQ(touching_points(edge, wide_floor, upwards, 1e-3).size, tilt < 1e-3 ? 2 : 1);
  }
  for (const double off : {1e-4, 1e-2}) {  // beyond the floor's side
    const Corners corner{Vec3(0, -4 - off, 0), Vec3(1, 0, 1), Vec3(0, 0, 2)};
    const TouchingPoints found = touching_points(corner, wide_floor, upwards, 1e-3);
    EXPECT_EQ(found.begin()->on_probe, corner[0]);
    const Vec3 there = found.begin()->on_fixed;
    if (off < 1e-3) {
      EXPECT_LT((there - Vec3(0, -4, 0)).norm(), 1e-14);
    } else {
      EXPECT_TRUE(std::ranges::find(wide_floor, there) != wide_floor.end());
    }
  }
}

/// Is x over t, as seen along n, or outside by no more than `margin` (a length)?
bool is_over(const Corners& t, const Vec3& n, const Vec3& x, double margin) {
  const double turn = n.dot((t[1] - t[0]).cross(t[2] - t[0])) > 0 ? 1 : -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 e = t[(i + 1) % 3] - t[i];
    if (turn * n.dot(e.cross(x - t[i])) < -margin * e.norm()) return false;
  }
  return true;
}

// Reference: points strewn over one face. The points found lie on both faces, and those strewn that
// lie over the other do not stick out of them in any direction.
TEST(TouchingPoints, of_faces_are_the_corners_of_their_common_part) {
  std::mt19937_64 random(1);
  int strewn = 0, most = 0;
  for (int i = 0; i < 500; ++i) {
    const Quat q = test::random_rotation(random);
    const Vec3 n = q * Vec3::UnitZ();
    const auto flat = [&](double height) {
      Corners t;
      for (Vec3& x : t)
        x = q * Vec3(test::uniform(random, -1, 1), test::uniform(random, -1, 1), height);
      return t;
    };
    const double gap = test::uniform(random, -1e-6, 1e-6);
    const Corners a = flat(gap), b = flat(0);
    const TouchingPoints found = touching_points(a, b, n, 1e-9);
    most = std::max(most, found.size);
    bool overlap = false;
    for (int k = 0; k < 40; ++k) {
      double u = test::uniform(random, 0, 1), v = test::uniform(random, 0, 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec3 x = a[0] + u * (a[1] - a[0]) + v * (a[2] - a[0]);
      if (!is_over(b, n, x, 0)) continue;
      overlap = true;
      ++strewn;
      for (int d = 0; d < 6; ++d) {
        const Vec3 way = test::random_in_ball(random, 1);
        double farthest = -1e300;
        for (const Contact& c : found) farthest = std::max(farthest, way.dot(c.on_probe));
        EXPECT_LE(way.dot(x), farthest + 1e-8) << i;  // the slack, and corners within it
      }
    }
    if (!overlap) continue;
    EXPECT_GE(found.size, 3);
    for (const Contact& c : found) {
      EXPECT_TRUE(is_over(a, n, c.on_probe, 1e-12)) << i;
      EXPECT_TRUE(is_over(b, n, c.on_fixed, 1e-12)) << i;
      EXPECT_NEAR(c.gap, gap, 1e-15);
      EXPECT_LT((c.on_probe - c.on_fixed - gap * n).norm(), 2e-9) << i;  // the slack
    }
  }
  EXPECT_GT(strewn, 2000);
  EXPECT_GE(most, 5);
}

TEST(TouchingPoints, does_not_allocate) {
  test::AllocationCounter counter;
  const int size = touching_points(wide_floor, wide_floor, upwards, 1e-9).size;
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
  EXPECT_GE(size, 3);
  EXPECT_LE(size, 15);
}

}  // namespace
}  // namespace sonde
