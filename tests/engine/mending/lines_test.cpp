// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::vector<std::vector<LineHit>> all_hits(const Lines& lines) {
  std::vector<std::vector<LineHit>> all(lines.size());
  EXPECT_TRUE(lines.each([&](std::size_t i, std::span<const LineHit> hits) {
    all[i].assign(hits.begin(), hits.end());
    return true;
  }));
  return all;
}

// A property that holds exactly: a closed surface is left as often as it is entered.
TEST(Lines, of_a_closed_mesh_no_line_slips_through) {
  for (const PolygonSoup& mesh :
       {test::box({1, 2, 3}), test::torus(1, 0.3, 31, 17), test::icosphere(2, 3),
        test::torus_knot(2, 3, 2, 0.7, 0.3, 60, 8)})
    for (int k = 0; k < 3; ++k) {
      const Soup soup = test::soup_of(mesh);
      const Lines lines(soup, line_frame(k), 200);
      std::size_t met = 0;
      for (const std::vector<LineHit>& hits : all_hits(lines)) {
        int sum = 0;
        for (const LineHit& hit : hits) sum += hit.sign;
        EXPECT_EQ(sum, 0);
        met += !hits.empty();
      }
      EXPECT_GT(met, 1000u);
    }
}

// Reference: the sphere's equation, with the error of an icosphere of 20480 triangles.
TEST(Lines, hits_lie_on_the_surface_and_are_signed_by_its_front) {
  const Soup soup = test::soup_of(test::icosphere(1, 5));
  const Lines lines(soup, line_frame(1), 64);
  const std::vector<std::vector<LineHit>> all = all_hits(lines);
  std::size_t looked = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].empty()) continue;
    ASSERT_EQ(all[i].size(), 2u);
    EXPECT_LE(all[i][0].along, all[i][1].along);
    EXPECT_EQ(all[i][0].sign, -1);
    EXPECT_EQ(all[i][1].sign, 1);
    for (const LineHit& hit : all[i]) EXPECT_NEAR(lines.point(i, hit.along).norm(), 1, 2e-3);
    ++looked;
  }
  EXPECT_GT(looked, 2000u);
}

// Reference: the same lines through the soup's near part alone.
TEST(Lines, a_raster_smaller_than_the_soup_sees_what_lies_in_it) {
  const Soup soup = test::soup_of(test::box({1e6, 1e6, 2}));
  const Lines lines(soup, Eigen::Matrix3d::Identity(), 16, {-1, -1}, 2);
  for (const std::vector<LineHit>& hits : all_hits(lines)) {
    ASSERT_EQ(hits.size(), 2u);
    EXPECT_NEAR(hits[0].along, -1, 1e-9);
    EXPECT_NEAR(hits[1].along, 1, 1e-9);
  }
}

// Many sheets across each other: the hits of few rows are found at a time. Reference: each sheet by
// itself.
TEST(Lines, the_hits_of_many_triangles_are_those_of_each) {
  std::mt19937_64 random(1);
  const Soup soup = test::soup_of(test::random_soup(random, 4000, 1));
  const Lines lines(soup, line_frame(2), 100, {-1, -1}, 2);
  std::vector<std::vector<LineHit>> expected(lines.size()), unordered(lines.size());
  Soup one{soup.vertices, {}};
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    one.triangles = {soup.triangles[t]};
    Lines(one, line_frame(2), 100, {-1, -1}, 2)
        .each([&](std::size_t i, std::span<const LineHit> hits) {
          expected[i].push_back({hits[0].along, t, hits[0].sign});
          return hits.size() == 1;
        });
  }
  EXPECT_TRUE(lines.each_unordered([&](std::size_t i, std::span<const LineHit> hits) {
    unordered[i].assign(hits.begin(), hits.end());
    return true;
  }));
  const std::vector<std::vector<LineHit>> all = all_hits(lines);
  std::size_t met = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (auto* hits : {&expected[i], &unordered[i]})
      std::ranges::sort(*hits, {}, [](const LineHit& hit) { return hit.along; });
    ASSERT_EQ(all[i].size(), expected[i].size());
    ASSERT_EQ(all[i].size(), unordered[i].size());
    for (std::size_t k = 0; k < all[i].size(); ++k)
      for (const LineHit& other : {expected[i][k], unordered[i][k]}) {
        EXPECT_EQ(all[i][k].along, other.along);
        EXPECT_EQ(all[i][k].triangle, other.triangle);
        EXPECT_EQ(all[i][k].sign, other.sign);
      }
    met += all[i].size();
  }
  EXPECT_GT(met, 50'000u);
}

TEST(Lines, can_be_left_early_and_cancelled) {
  const Soup soup = test::soup_of(test::icosphere(1, 3));
  const Lines lines(soup, line_frame(0), 512);
  std::size_t used = 0;
  EXPECT_FALSE(lines.each([&](std::size_t, std::span<const LineHit>) { return ++used < 10; }));
  EXPECT_EQ(used, 10u);
  int reports = 0;
  EXPECT_THROW(lines.each([](std::size_t, std::span<const LineHit>) { return true; },
                          [&](double) { return ++reports < 3; }),
               Cancelled);
  EXPECT_EQ(reports, 3);
}

}  // namespace
}  // namespace sonde
