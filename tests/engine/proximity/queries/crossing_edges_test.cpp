// SPDX-License-Identifier: GPL-3.0-or-later
// Two edges that cross at a small angle, one right above the other: where products of differences
// lose all their digits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/near_pairs.hpp"
#include "tests/support/adversarial.hpp"
#include "tests/support/exact_reference.hpp"

namespace sonde {
namespace {

struct Crossing {
  Corners a, b;
  double gap, angle;
};

/// A above the edge along x, B below an edge at `angle` to it, `gap` lower; both as slim as you
/// like, turned and moved. Rounding of the corners turns a gap of 0 into some 1e-16 or a crossing.
Crossing crossing(std::mt19937_64& random) {
  const double gaps[] = {0, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5, 1e-3};
  const double gap = gaps[random() % 8];
  const double angle = std::exp2(-test::uniform(random, 1, 40));
  const auto third = [&](double side) {
    const double width = std::exp2(-test::uniform(random, 0, 27));
    const double lean = test::uniform(random, -width, width);
    return Vec3(test::uniform(random, -1, 1), lean, side * width);
  };
  const double at = test::uniform(random, -0.9, 0.9);
  Crossing c{{Vec3(-1, 0, 0), Vec3(1, 0, 0), third(1)},
             {Vec3(-1, angle * (-1 - at), 0), Vec3(1, angle * (1 - at), 0), third(-1)},
             gap,
             angle};
  for (Vec3& x : c.a) x.z() += gap;
  const Mat3 R = test::random_rotation(random).toRotationMatrix();
  const Vec3 by = random() % 2 ? test::random_in_ball(random, 1) : Vec3(Vec3::Zero());
  for (Corners* t : {&c.a, &c.b}) {
    for (Vec3& x : *t) x = R * x + by;
    std::shuffle(t->begin(), t->end(), random);
  }
  return c;
}

constexpr double size = 3;  // no coordinate is larger, both triangles together

// Reference: exact distances. The promise is that of distance.hpp.
TEST(CrossingEdges, have_the_distance_of_exact_arithmetic) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 4000; ++i) {
    const Crossing c = crossing(random);
    const ClosestPoints found = closest_points(c.a, c.b);
    EXPECT_NEAR(found.distance, test::exact_distance(c.a, c.b), 1e-14 * size)
        << i << ", angle " << c.angle << ", gap " << c.gap;
    EXPECT_NEAR((found.a - found.b).norm(), found.distance, 1e-14 * size);
  }
}

// Reference: exact distances, and the gap along the normal in exact arithmetic.
TEST(CrossingEdges, have_a_separator_with_nearly_all_of_the_distance) {
  std::mt19937_64 random(2);
  int apart = 0;
  for (int i = 0; i < 4000; ++i) {
    const Crossing c = crossing(random);
    const double distance = test::exact_distance(c.a, c.b);
    const ClosestPoints s = closest_points(c.a, c.b);
    if (s.distance <= 0) {  // too near to be told from touching: there is no normal
      EXPECT_LE(distance, 1e-15 * size);
      continue;
    }
    EXPECT_NEAR(s.gap, test::exact_gap_along(s.normal, c.a, c.b), 1e-15 * size);
    EXPECT_LE(s.gap, distance + 1e-15 * size);
    EXPECT_GE(s.gap, 0.99 * distance - 2e-15 * size)
        << i << ", angle " << c.angle << ", gap " << c.gap;
    apart += distance > 1e-14;
  }
  EXPECT_GT(apart, 2000);
}

// Reference: exact predicates and distances. In doubt: classify()'s 32 roundings, as many again.
TEST(CrossingEdges, are_in_doubt_only_within_rounding) {
  std::mt19937_64 random(3);
  int doubtful = 0;
  for (int i = 0; i < 4000; ++i) {
    const Crossing c = crossing(random);
    const Meeting m = classify(c.a, c.b);
    const bool meet = test::meet_by_edges(c.a, c.b);
    EXPECT_FALSE(m == Meeting::apart && meet) << i;
    EXPECT_FALSE(m == Meeting::meeting && !meet) << i;
    if (m != Meeting::doubtful) continue;
    ++doubtful;
    EXPECT_LE(test::exact_distance(c.a, c.b), 64 * 0x1p-52 * size) << i << ", angle " << c.angle;
  }
  EXPECT_GT(doubtful, 100);
}

std::shared_ptr<const Body> one_triangle(const Corners& t) {
  return test::body({{t[0], t[1], t[2]}, {{0, 1, 2}}}, Model::surface);
}

// The same of bodies: within reach is within reach.
TEST(CrossingEdges, are_found_within_reach) {
  std::mt19937_64 random(4);
  std::vector<NearPair> out(4);
  int found = 0;
  for (int i = 0; i < 1000; ++i) {
    const Crossing c = crossing(random);
    const auto a = one_triangle(c.a), b = one_triangle(c.b);
    const double distance = test::exact_distance(c.a, c.b);
    EXPECT_NEAR(triangle_distance(*a, *b, {}).distance, distance, 1e-14 * size) << i;
    EXPECT_EQ(triangles_meet(*a, *b, {}, Doubt::exact), distance <= 0) << i;
    if (distance < 1e-13) continue;
    const NearPairs near = near_pairs(*a, *b, {}, 1.01 * distance + 1e-14 * size, out);
    ASSERT_EQ(near.count, 1u) << i << ", angle " << c.angle << ", gap " << c.gap;
    EXPECT_GT(out[0].gap, 0.99 * distance - 1e-14 * size);
    ++found;
  }
  EXPECT_GT(found, 500);
}

}  // namespace
}  // namespace sonde
