// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/by_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace sonde {
namespace {

// Reference: each triangle's place in an ordered map by its sorted corners.
TEST(TrianglesByCorners, alike_ones_lie_beside_each_other_in_order) {
  std::mt19937_64 random(5);
  for (const std::uint32_t vertices : {3u, 4u, 9u, 200u}) {
    Soup soup{std::vector<Vec3>(vertices, Vec3::Zero()), {}};
    while (soup.triangles.size() < 300) {
      Triangle t;
      for (std::uint32_t& corner : t) corner = static_cast<std::uint32_t>(random() % vertices);
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) soup.triangles.push_back(t);
    }
    std::map<Triangle, std::vector<std::uint32_t>> wanted;
    for (std::uint32_t i = 0; i < 300; ++i) {
      Triangle t = soup.triangles[i];
      std::sort(t.begin(), t.end());
      wanted[t].push_back(i);
    }
    const auto all = triangles_by_corners(soup);
    ASSERT_EQ(all.size(), 300u);
    auto next = wanted.begin();
    for_each_alike(all, [&](std::span<const CornerTriangle> alike) {
      ASSERT_NE(next, wanted.end());
      ASSERT_EQ(alike.size(), next->second.size());
      for (std::size_t k = 0; k < alike.size(); ++k) {
        EXPECT_EQ(alike[k].corners, next->first);
        EXPECT_EQ(alike[k].triangle, next->second[k]);
        const auto& [a, b, c] = soup.triangles[alike[k].triangle];
        EXPECT_EQ(alike[k].even, (a < b) + (b < c) + (c < a) == 2);
      }
      ++next;
    });
    EXPECT_EQ(next, wanted.end());
  }
}

}  // namespace
}  // namespace sonde
