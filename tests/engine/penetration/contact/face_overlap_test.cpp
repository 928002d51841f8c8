// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/face_overlap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

struct FacePair {
  Corners a, b;
  Vec3 normal;
};

/// Two triangles nearly flat on each other, seen along a direction near to both their normals.
FacePair random_pair(std::mt19937_64& random) {
  const Quat q = test::random_rotation(random);
  const auto triangle = [&](double height) {
    Corners t;
    for (Vec3& x : t)
      x = q * Vec3(test::uniform(random, -1, 1), test::uniform(random, -1, 1),
                   height + test::uniform(random, -0.1, 0.1));
    return t;
  };
  const Corners a = triangle(0.3), b = triangle(0);
  const Vec3 n = q * (Vec3::UnitZ() + test::random_in_ball(random, 0.1)).normalized();
  return {a, b, n};
}

/// Does x lie over t, seen along n? By the signs of three areas, with a margin (a length).
bool covers(const Corners& t, const Vec3& n, const Vec3& x, double margin) {
  int above = 0, below = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 e = t[(i + 1) % 3] - t[i];
    const double area = n.dot(e.cross(x - t[i])) / e.norm();
    above += area > -margin, below += area < margin;
  }
  return above == 3 || below == 3;
}

TEST(FaceOverlap, corners_lie_on_both_triangles_and_their_gap_is_between_them) {
  std::mt19937_64 random(1);
  int corners = 0;
  for (int i = 0; i < 3000; ++i) {
    const FacePair p = random_pair(random);
    const Vec3 plane_a = (p.a[1] - p.a[0]).cross(p.a[2] - p.a[0]).normalized(),
               plane_b = (p.b[1] - p.b[0]).cross(p.b[2] - p.b[0]).normalized();
    for (const Contact& c : face_overlap(p.a, p.b, p.normal)) {
      EXPECT_NEAR(plane_a.dot(c.on_probe - p.a[0]), 0, 1e-12);
      EXPECT_NEAR(plane_b.dot(c.on_fixed - p.b[0]), 0, 1e-12);
      EXPECT_TRUE(covers(p.a, p.normal, c.on_probe, 1e-12));
      EXPECT_TRUE(covers(p.b, p.normal, c.on_fixed, 1e-12));
      EXPECT_LT((c.on_probe - c.on_fixed - c.gap * c.normal).norm(), 1e-12);
      EXPECT_EQ(c.normal, p.normal);
      ++corners;
    }
  }
  EXPECT_GT(corners, 3000);
}

// Reference: points strewn over A; those over B as well must not stick out of the corners in any
// direction. So no corner is missing.
TEST(FaceOverlap, its_corners_hold_every_point_that_lies_over_the_other_triangle) {
  std::mt19937_64 random(2);
  int over = 0;
  for (int i = 0; i < 1000; ++i) {
    const FacePair p = random_pair(random);
    const FaceOverlap found = face_overlap(p.a, p.b, p.normal);
    for (int k = 0; k < 60; ++k) {
      double u = test::uniform(random, 0, 1), v = test::uniform(random, 0, 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec3 x = p.a[0] + u * (p.a[1] - p.a[0]) + v * (p.a[2] - p.a[0]);
      if (!covers(p.b, p.normal, x, -1e-9)) continue;
      ++over;
      ASSERT_GE(found.size, 3);
      for (int d = 0; d < 8; ++d) {
        const Vec3 way = test::random_in_ball(random, 1);
        double farthest = -1e300;
        for (const Contact& c : found) farthest = std::max(farthest, way.dot(c.on_probe));
        EXPECT_LE(way.dot(x), farthest + 1e-12);
      }
    }
  }
  EXPECT_GT(over, 3000);
}

TEST(FaceOverlap, is_empty_where_nothing_overlaps_or_is_seen_edge_on) {
  const Corners t = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const auto moved = [&](const Vec3& by) { return Corners{t[0] + by, t[1] + by, t[2] + by}; };
  EXPECT_EQ(face_overlap(moved({2, 0, 0.1}), t, Vec3::UnitZ()).size, 0);
  EXPECT_EQ(face_overlap(moved({0, 0, 0.1}), t, Vec3::UnitX()).size, 0);
  const FaceOverlap all = face_overlap(moved({0, 0, 0.25}), t, Vec3::UnitZ());
  EXPECT_EQ(all.size, 3);
  for (const Contact& c : all) EXPECT_EQ(c.gap, 0.25);
  // The most there can be: two triangles crossed like a star.
  const auto corner = [](double angle, double z) {
    return Vec3(std::cos(angle), std::sin(angle), z);
  };
  const double third = 2.0943951023931953;
  const Corners up = {corner(0, 0.1), corner(third, 0.1), corner(2 * third, 0.1)};
  const Corners down = {corner(third / 2, 0), corner(1.5 * third, 0), corner(2.5 * third, 0)};
  EXPECT_EQ(face_overlap(up, down, Vec3::UnitZ()).size, 6);
}

TEST(FaceOverlap, does_not_allocate) {
  std::mt19937_64 random(3);
  const FacePair p = random_pair(random);
  test::AllocationCounter counter;
  const int size = face_overlap(p.a, p.b, p.normal).size;
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u) << size;
}

}  // namespace
}  // namespace sonde
