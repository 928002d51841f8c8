// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/repeated.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <vector>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

using Left = std::vector<bool>;

Soup soup_with(std::vector<Triangle> triangles) {
  return {std::vector<Vec3>(9, Vec3::Zero()), std::move(triangles)};
}

// Reference: by hand.
TEST(Repeated, one_of_each_orientation_stays) {
  const Soup soup = soup_with({{0, 1, 2}, {1, 2, 0}, {0, 2, 1}, {3, 4, 5}, {2, 0, 1}, {2, 1, 0}});
  EXPECT_EQ(repeated_triangles(soup, false), (Left{false, true, false, false, true, true}));
  EXPECT_EQ(repeated_triangles(soup_with({}), false), Left{});
  EXPECT_EQ(repeated_triangles(soup_with({{0, 1, 2}, {0, 1, 3}}), true), (Left{false, false}));
}

// Reference: by hand. A closed surface of which everything is there twice needs it once; of which
// one triangle alone is there three times, that one counts for three.
TEST(Repeated, of_a_solid_as_many_stay_as_keep_the_ratios_of_windings) {
  EXPECT_EQ(repeated_triangles(soup_with({{0, 1, 2}, {1, 2, 0}, {0, 1, 3}, {3, 0, 1}}), true),
            (Left{false, true, false, true}));
  EXPECT_EQ(repeated_triangles(soup_with({{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 1, 3}}), true),
            (Left{false, false, false, false}));
  // Four and two: twice and once.
  EXPECT_EQ(
      repeated_triangles(
          soup_with({{0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 3, 1}, {0, 3, 1}}), true),
      (Left{false, false, true, true, false, true}));
  // Two of one and one of the other orientation: one is left.
  EXPECT_EQ(repeated_triangles(soup_with({{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {0, 1, 3}}), true),
            (Left{false, true, true, false}));
  // As often in both: once in each, as a sheet.
  EXPECT_EQ(
      repeated_triangles(soup_with({{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {0, 2, 1}, {0, 1, 3}}), true),
      (Left{false, false, true, true, false}));
  EXPECT_EQ(repeated_triangles(soup_with({{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {0, 2, 1}}), true),
            (Left{false, false, true, true}));
}

/// How many more of each set of corners have one orientation than the other, by permutations.
std::map<std::vector<std::uint32_t>, long> turns_of(const Soup& soup, const Left& left_out) {
  std::map<std::vector<std::uint32_t>, long> out;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    std::vector<std::uint32_t> corners(t.begin(), t.end());
    std::ranges::sort(corners);
    const auto first = std::ranges::find(t, corners[0]) - t.begin();
    const bool even = t[static_cast<std::size_t>((first + 1) % 3)] == corners[1];
    out[corners] += left_out.empty() || !left_out[i] ? (even ? 1 : -1) : 0;
  }
  return out;
}

// Reference: counts of each orientation. All of a solid's are divided by one number, and what is
// left of each set has one orientation, or one triangle of each.
TEST(Repeated, what_stays_of_a_solid_winds_a_fixed_share_as_often) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200; ++i) {
    std::vector<Triangle> triangles;
    const long common = 1 + static_cast<long>(random() % 3);
    for (std::uint32_t k = 2; k < 6; ++k) {
      const long turns = common * (static_cast<long>(random() % 5) - 2);
      const long both = static_cast<long>(random() % 3);
      for (long n = 0; n < std::abs(turns) + both; ++n)
        triangles.push_back(turns > 0 ? Triangle{0, 1, k} : Triangle{1, 0, k});
      for (long n = 0; n < both; ++n)
        triangles.push_back(turns > 0 ? Triangle{0, k, 1} : Triangle{0, 1, k});
    }
    std::shuffle(triangles.begin(), triangles.end(), random);
    const Soup soup = soup_with(triangles);
    const Left out = repeated_triangles(soup, true);
    const auto before = turns_of(soup, {}), after = turns_of(soup, out);
    long divisor = 0;
    for (const auto& [corners, turns] : before) divisor = std::gcd(divisor, turns);
    std::size_t wanted = 0;
    for (const auto& [corners, turns] : before) {
      EXPECT_EQ(after.at(corners) * divisor, turns);
      wanted += turns == 0 ? 2 : static_cast<std::size_t>(std::abs(turns / divisor));
    }
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(out, false)), wanted);
  }
}

TEST(Repeated, can_be_cancelled) {
  const Soup soup = soup_with({{0, 1, 2}});
  EXPECT_THROW(repeated_triangles(soup, true, [](double) { return false; }), Cancelled);
}

}  // namespace
}  // namespace sonde
