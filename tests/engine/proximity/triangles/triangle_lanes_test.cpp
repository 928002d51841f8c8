// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/triangles/triangle_lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "engine/base/numbers.hpp"
#include "tests/engine/proximity/triangles/supported_sets.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/triangle_families.hpp"
#include "tests/support/wide_distance.hpp"

namespace sonde {
namespace {

using test::supported_sets;
using test::TrianglePair;

/// Eight pairs of one family at one place, and what they are called in a message.
struct Batch {
  std::array<TrianglePair, 8> pair;
  TrianglePairs8 lanes;
  std::string name;
};

template <class Check>
void for_all_batches(std::uint64_t seed, int batches_each, const Check& check) {
  std::mt19937_64 random(seed);
  for (const test::TriangleFamily& family : test::triangle_families())
    for (const test::TrianglePlace& place : test::triangle_places())
      for (int i = 0; i < batches_each; ++i) {
        Batch batch;
        batch.name = std::string(family.name) + ", size " + std::to_string(place.scale) + ", " +
                     std::to_string(i);
        for (int lane = 0; lane < 8; ++lane) {
          TrianglePair& pair = batch.pair[static_cast<std::size_t>(lane)];
          pair = test::placed(family.make(random), place);
          set_lane(batch.lanes, lane, pair.a, pair.b);
        }
        check(batch);
      }
}

/// One lane's results.
struct Result {
  Vec3 a, b, normal;
  double distance, gap;
};
Result result(const ClosestPoints8& out, int lane) {
  const auto vector = [lane](const double x[3][8]) {
    return Vec3(x[0][lane], x[1][lane], x[2][lane]);
  };
  return {vector(out.a), vector(out.b), vector(out.normal), out.distance[lane], out.gap[lane]};
}

/// To the bit, where there is something to read.
bool same(const Result& x, const Result& y) {
  const auto number = [](double p, double q) {
    return std::bit_cast<std::uint64_t>(p) == std::bit_cast<std::uint64_t>(q);
  };
  const auto vector = [&](const Vec3& p, const Vec3& q) {
    return number(p.x(), q.x()) && number(p.y(), q.y()) && number(p.z(), q.z());
  };
  if (!number(x.distance, y.distance)) return false;
  if (std::isinf(x.distance)) return true;
  return vector(x.a, y.a) && vector(x.b, y.b) && number(x.gap, y.gap) &&
         (x.distance == 0 || vector(x.normal, y.normal));
}

/// Rounding of the distance and of the gap, m: several times what is seen (4e-16 of the size).
double rounding(const TrianglePair& p) { return 1e-15 * test::size_of(p); }
/// Rounding of a point, whose coordinates may be large.
double rounding_of_points(const TrianglePair& p) { return rounding(p) + 4e-16 * test::reach_of(p); }

void check_result(const Result& r, const TrianglePair& p, bool with_points,
                  const std::string& what) {
  const test::WideBounds bounds = test::wide_distance(p.a, p.b);
  ASSERT_GE(r.distance, bounds.lower - rounding(p)) << what;
  ASSERT_LE(r.distance, bounds.upper + rounding(p)) << what;
  ASSERT_NEAR((r.a - r.b).norm(), r.distance, rounding_of_points(p)) << what;
  if (r.distance == 0) {
    ASSERT_EQ(r.a, r.b) << what;
  }
  if (!with_points) return;
  ASSERT_LE(test::wide_distance(r.a, p.a), rounding_of_points(p)) << what;
  ASSERT_LE(test::wide_distance(r.b, p.b), rounding_of_points(p)) << what;
}

// The reference is independent: other formulas in quadruple precision, and its two bounds prove
// each other. They are certain always; where they are further apart than rounding (needles and
// caps thinner than 1e-16 of their length, all but touching) only what they say is asked for.
void agrees_with_the_reference(std::uint64_t seed, int batches_each) {
  int tight = 0, all = 0;
  for_all_batches(seed, batches_each, [&](const Batch& batch) {
    ClosestPoints8 out;
    closest_points(batch.lanes, 8, infinity, out);
    for (int lane = 0; lane < 8; ++lane, ++all) {
      const TrianglePair& p = batch.pair[static_cast<std::size_t>(lane)];
      check_result(result(out, lane), p, lane == 0, batch.name);
    }
    const test::WideBounds bounds = test::wide_distance(batch.pair[0].a, batch.pair[0].b);
    tight += bounds.upper - bounds.lower <= rounding(batch.pair[0]);
  });
  EXPECT_GE(tight, all / 8 * 99 / 100);
}

TEST(TriangleLanes, distance_and_points_agree_with_quadruple_precision) {
  agrees_with_the_reference(1, 190);  // 100 000 pairs
}
TEST(TriangleLanes, Full_distance_and_points_agree_with_quadruple_precision) {
  agrees_with_the_reference(2, 6000);
}

TEST(TriangleLanes, every_instruction_set_gives_the_same_bits) {
  const std::vector<InstructionSet> sets = supported_sets();
  std::mt19937_64 random(3);
  for_all_batches(4, 200, [&](const Batch& batch) {
    const double limit = random() % 2 ? infinity : test::uniform(random, 0, 2);
    ClosestPoints8 first, other;
    closest_points_by(sets[0], batch.lanes, 8, limit, first);
    for (const InstructionSet set : sets) {
      closest_points_by(set, batch.lanes, 8, limit, other);
      for (int lane = 0; lane < 8; ++lane)
        ASSERT_TRUE(same(result(first, lane), result(other, lane)))
            << batch.name << ", lane " << lane << ", set " << static_cast<int>(set);
    }
    closest_points(batch.lanes, 8, limit, other);
    for (int lane = 0; lane < 8; ++lane)
      ASSERT_TRUE(same(result(first, lane), result(other, lane))) << batch.name;
  });
}

// Each pair again among pairs of other families, in another lane, with fewer lanes in use and
// numbers in the others that would hurt.
TEST(TriangleLanes, a_lane_does_not_depend_on_the_others) {
  std::mt19937_64 random(5);
  std::vector<TrianglePair> pairs;
  for_all_batches(6, 10, [&](const Batch& batch) {
    pairs.insert(pairs.end(), batch.pair.begin(), batch.pair.end());
  });
  const double bad[] = {infinity, std::numeric_limits<double>::quiet_NaN(), 5e-324, 1e300, 0};
  for (const InstructionSet set : supported_sets())
    for (const TrianglePair& p : pairs) {
      TrianglePairs8 lanes;
      ClosestPoints8 alone, among;
      set_lane(lanes, 0, p.a, p.b);
      closest_points_by(set, lanes, 1, infinity, alone);
      const int count = 1 + static_cast<int>(random() % 8);
      const int lane = static_cast<int>(random() % 8) % count;
      for (int i = 0; i < 8; ++i) {
        const TrianglePair& q = pairs[random() % pairs.size()];
        set_lane(lanes, i, q.a, q.b);
        const Vec3 x = Vec3::Constant(bad[random() % 5]);
        if (i >= count) set_lane(lanes, i, {x, x, x}, {x, x, x});
      }
      set_lane(lanes, lane, p.a, p.b);
      closest_points_by(set, lanes, count, infinity, among);
      ASSERT_TRUE(same(result(alone, 0), result(among, lane)));
    }
}

// A limit leaves the results alone and drops no lane that is within it by the certain lower bound.
TEST(TriangleLanes, a_limit_only_drops_what_is_beyond_it) {
  std::mt19937_64 random(7);
  int dropped = 0, beyond = 0;
  for_all_batches(8, 40, [&](const Batch& batch) {
    ClosestPoints8 all, limited;
    closest_points(batch.lanes, 8, infinity, all);
    const double limit = all.distance[random() % 8] * test::uniform(random, 0.5, 1.5);
    closest_points(batch.lanes, 8, limit, limited);
    for (int lane = 0; lane < 8; ++lane) {
      const TrianglePair& p = batch.pair[static_cast<std::size_t>(lane)];
      beyond += all.distance[lane] > limit;
      if (std::isinf(limited.distance[lane])) {
        ++dropped;
        ASSERT_GT(test::wide_distance(p.a, p.b).upper, limit) << batch.name;
      } else {
        ASSERT_TRUE(same(result(all, lane), result(limited, lane))) << batch.name;
      }
    }
    closest_points(batch.lanes, 8, all.distance[0], limited);
    ASSERT_EQ(limited.distance[0], all.distance[0]) << batch.name;
  });
  EXPECT_GT(dropped, beyond / 2);
}

// The gap is measured again in long double, along the normal as it was returned.
TEST(TriangleLanes, the_normal_separates_by_the_gap_and_hardly_less_than_the_distance) {
  int apart = 0, close = 0;
  for_all_batches(9, 40, [&](const Batch& batch) {
    ClosestPoints8 out;
    closest_points(batch.lanes, 8, infinity, out);
    for (int lane = 0; lane < 8; ++lane) {
      const TrianglePair& p = batch.pair[static_cast<std::size_t>(lane)];
      const Result r = result(out, lane);
      if (r.distance == 0) {
        ASSERT_EQ(r.gap, 0) << batch.name;
        continue;
      }
      ASSERT_NEAR(r.normal.norm(), 1, 1e-15) << batch.name;
      ASSERT_LE(r.gap, r.distance + rounding(p)) << batch.name;
      const auto n = r.normal.cast<long double>();
      long double gap = std::numeric_limits<long double>::infinity();
      for (const Vec3& x : p.a)
        for (const Vec3& y : p.b)
          gap = std::min(gap, n.dot(x.cast<long double>() - y.cast<long double>()));
      ASSERT_NEAR(static_cast<double>(gap), r.gap, rounding(p)) << batch.name;
      if (r.distance < 1e-5 * test::size_of(p)) continue;
      ++apart;
      close += r.gap >= 0.999 * r.distance;
    }
  });
  EXPECT_EQ(close, apart);
  EXPECT_GT(apart, 10000);
}

// Where the points are so close that their direction is lost to rounding, another is found, as by
// the scalar separator: as good as that or better.
TEST(TriangleLanes, tiny_gaps_have_a_normal) {
  std::mt19937_64 random(10);
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-14})
    for (int i = 0; i < 300; ++i) {
      TrianglePair p = test::triangle_families()[0].make(random);
      p.b[0] = p.a[1];
      if (i % 2) p.b[1] = p.a[2];
      const Vec3 n = (p.a[1] - p.a[0]).cross(p.a[2] - p.a[0]).normalized();
      for (Vec3& x : p.b) x += (gap + std::max(0.0, -2 * n.dot(x - p.a[0]))) * n;
      TrianglePairs8 lanes;
      set_lane(lanes, 0, p.a, p.b);
      ClosestPoints8 out;
      closest_points(lanes, 1, infinity, out);
      EXPECT_GE(out.gap[0], 0.9 * gap - 4 * rounding(p)) << gap << " " << i;
    }
}

TEST(TriangleLanes, known_distances) {
  const Corners a = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  const auto lifted = [&](const Vec3& by) { return Corners{a[0] + by, a[1] + by, a[2] + by}; };
  TrianglePairs8 lanes;
  set_lane(lanes, 0, a, lifted({0, 0, 0.25}));
  set_lane(lanes, 1, a, lifted({3, 0, 0}));
  set_lane(lanes, 2, a, lifted({0.1, 0.1, 0}));
  set_lane(lanes, 3, a, a);
  set_lane(lanes, 4, a, {Vec3(0.2, 0.2, -1), Vec3(0.2, 0.2, 1), Vec3(5, 5, 1)});
  set_lane(lanes, 5, {a[1], a[1], a[1]}, {a[2], a[2], a[2]});
  const Vec3 origin = Vec3::Zero(), next_to_it = Vec3(1e-150, 0, 0);
  set_lane(lanes, 6, {origin, origin, origin}, {next_to_it, next_to_it, next_to_it});
  ClosestPoints8 out;
  closest_points(lanes, 7, infinity, out);
  EXPECT_EQ(out.distance[0], 0.25);
  EXPECT_EQ(out.gap[0], 0.25);
  EXPECT_EQ(result(out, 0).normal, Vec3(0, 0, -1));
  EXPECT_EQ(out.distance[1], 2);
  EXPECT_EQ(result(out, 1).a, Vec3(1, 0, 0));
  EXPECT_EQ(result(out, 1).b, Vec3(3, 0, 0));
  for (int lane = 2; lane < 5; ++lane) EXPECT_EQ(out.distance[lane], 0) << lane;
  const Vec3 common = result(out, 4).a;
  EXPECT_NEAR(common.z(), 0, 1e-15);
  EXPECT_NEAR(common.x(), common.y(), 1e-15);
  EXPECT_TRUE(common.x() > 0.19 && common.x() < 0.51) << common;
  EXPECT_DOUBLE_EQ(out.distance[5], std::sqrt(2));
  EXPECT_EQ(out.distance[6], 0);
  EXPECT_EQ(result(out, 6).a, result(out, 6).b);
  closest_points(lanes, 7, 1.0, out);
  EXPECT_EQ(out.distance[0], 0.25);
  EXPECT_EQ(out.distance[1], infinity);
}

// A mesh's neighbours meet exactly, wherever they are.
TEST(TriangleLanes, shared_corners_and_edges_are_at_distance_0) {
  for_all_batches(11, 100, [&](const Batch& batch) {
    if (!batch.name.starts_with("shared") && !batch.name.starts_with("duplicate")) return;
    ClosestPoints8 out;
    closest_points(batch.lanes, 8, infinity, out);
    for (const double distance : out.distance) ASSERT_EQ(distance, 0) << batch.name;
  });
}

TEST(TriangleLanes, nothing_is_allocated) {
  std::mt19937_64 random(12);
  TrianglePairs8 lanes;
  for (int lane = 0; lane < 8; ++lane) {
    const auto families = test::triangle_families();
    const TrianglePair p = families[random() % families.size()].make(random);
    set_lane(lanes, lane, p.a, p.b);
  }
  ClosestPoints8 out;
  double sum = 0;
  test::AllocationCounter counter;
  for (int count = 1; count <= 8; ++count) {
    closest_points(lanes, count, 1, out);
    sum += out.gap[0];
  }
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u) << sum;
}

}  // namespace
}  // namespace sonde
