// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/triangles/pair_lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "engine/proximity/triangles/triangle_pair.hpp"
#include "tests/engine/proximity/triangles/supported_sets.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::supported_sets;

/// Eight pairs, two places of A, and how it is bent, with what plain code makes of them.
struct EightPairs {
  PairLanes lanes;
  Corners arms[8], fixed[8];
  Vec3 normal[8];
  Mat3 R[2], bend;
  Vec3 p[2];
  double size, far;

  EightPairs(std::mt19937_64& random, double size_of, double distance)
      : size(size_of), far(distance) {
    const auto point = [&](double within) { return test::random_in_ball(random, within); };
    const Vec3 there = far * point(1).normalized();
    for (int i = 0; i < 8; ++i) {
      normal[i] = point(1).normalized();
      for (Vec3& x : arms[i]) x = point(size);
      for (Vec3& x : fixed[i]) x = there + point(size);
      for (int k = 0; k < 3; ++k) {
        lanes.normal[k][i] = normal[i][k];
        for (std::size_t c = 0; c < 3; ++c) lanes.arm[c][k][i] = arms[i][c][k];
      }
      lanes.top[i] = top(i);
    }
    for (int k = 0; k < 2; ++k)
      R[k] = test::random_rotation(random).toRotationMatrix(), p[k] = there + point(size);
    for (int k = 0; k < 9; ++k) bend(k / 3, k % 3) = test::uniform(random, -1, 1);
  }
  double top(int i) const {
    return std::max(
        {normal[i].dot(fixed[i][0]), normal[i].dot(fixed[i][1]), normal[i].dot(fixed[i][2])});
  }
  double gap(int i, int k) const {
    Corners placed = arms[i];
    for (Vec3& x : placed) x = R[k] * x + p[k];
    return gap_along(normal[i], placed, fixed[i]);
  }
  double most_bend(int i) const {
    double most = -1e300;
    for (const Vec3& x : arms[i]) most = std::max(most, normal[i].dot(bend * x));
    return most;
  }
  ArmMap at(int k) const { return arm_map(R[k], p[k]); }
  double rounding() const { return 1e-15 * (8 * size + 4 * far); }
};

template <class Check>
void for_cases(std::uint64_t seed, const Check& check) {
  std::mt19937_64 random(seed);
  for (const double size : {1e-9, 1e-3, 1.0, 1e6})
    for (const double far : {0.0, 1.0, 1e3})
      for (int i = 0; i < 200; ++i) check(EightPairs(random, size, far * size));
}

bool same(const double (&x)[8], const double (&y)[8]) {
  return std::equal(x, x + 8, y, [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  });
}

// Reference: gap_along of the placed corners.
TEST(PairLanes, gaps_are_those_of_plain_code) {
  for_cases(1, [](const EightPairs& c) {
    alignas(64) double gap[8];
    gaps_at(c.lanes, c.at(0), gap);
    PathLanes path;
    gaps_along(c.lanes, c.at(0), c.at(1), arm_map(c.bend, Vec3::Zero()), path);
    EXPECT_TRUE(same(gap, path.from));
    for (int i = 0; i < 8; ++i) {
      EXPECT_NEAR(path.from[i], c.gap(i, 0), c.rounding());
      EXPECT_NEAR(path.to[i], c.gap(i, 1), c.rounding());
      EXPECT_NEAR(path.bend[i], c.most_bend(i), 1e-14 * c.size);
    }
  });
}

TEST(PairLanes, every_instruction_set_gives_the_same_bits) {
  const std::vector<InstructionSet> sets = supported_sets();
  ASSERT_FALSE(sets.empty());
  EXPECT_TRUE(is_supported(instruction_set()));
  for_cases(2, [&](const EightPairs& c) {
    const ArmMap bend = arm_map(c.bend, Vec3::Zero());
    alignas(64) double first[8], other[8];
    PathLanes first_path, other_path;
    gaps_at_by(InstructionSet::baseline, c.lanes, c.at(0), first);
    gaps_along_by(InstructionSet::baseline, c.lanes, c.at(0), c.at(1), bend, first_path);
    const auto compare = [&] {
      EXPECT_TRUE(same(first, other));
      EXPECT_TRUE(same(first_path.from, other_path.from));
      EXPECT_TRUE(same(first_path.to, other_path.to));
      EXPECT_TRUE(same(first_path.bend, other_path.bend));
    };
    for (const InstructionSet set : sets) {
      gaps_at_by(set, c.lanes, c.at(0), other);
      gaps_along_by(set, c.lanes, c.at(0), c.at(1), bend, other_path);
      compare();
    }
    gaps_at(c.lanes, c.at(0), other);
    gaps_along(c.lanes, c.at(0), c.at(1), bend, other_path);
    compare();
  });
}

TEST(PairLanes, a_lane_does_not_depend_on_the_others) {
  std::mt19937_64 random(3);
  for_cases(3, [&](const EightPairs& c) {
    PairLanes others = c.lanes;
    const auto lane = static_cast<int>(random() % 8);
    for (int i = 0; i < 8; ++i)
      if (i != lane)
        others.arm[0][0][i] = others.top[i] = std::nan(""), others.normal[1][i] = 1e300;
    alignas(64) double gap[8], among[8];
    gaps_at(c.lanes, c.at(0), gap);
    gaps_at(others, c.at(0), among);
    EXPECT_EQ(gap[lane], among[lane]);
  });
}

// A lane without a direction, as of pairs that meet.
TEST(PairLanes, no_direction_leaves_no_gap) {
  std::mt19937_64 random(4);
  const EightPairs c(random, 1, 1);
  PairLanes none = c.lanes;
  for (int i = 0; i < 8; ++i)
    none.normal[0][i] = none.normal[1][i] = none.normal[2][i] = none.top[i] = 0;
  alignas(64) double gap[8];
  gaps_at(none, c.at(0), gap);
  for (const double g : gap) EXPECT_EQ(g, 0);
}

TEST(PairLanes, do_not_allocate) {
  std::mt19937_64 random(5);
  const EightPairs c(random, 1, 1);
  alignas(64) double gap[8];
  PathLanes path;
  test::AllocationCounter counter;
  gaps_at(c.lanes, c.at(0), gap);
  gaps_along(c.lanes, c.at(0), c.at(1), c.at(1), path);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
}

}  // namespace
}  // namespace sonde
