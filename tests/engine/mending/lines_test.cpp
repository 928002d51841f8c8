// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/lines.hpp"

#include <gtest/gtest.h>

#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// A property that holds exactly: a closed surface is left as often as it is entered.
TEST(Lines, of_a_closed_mesh_no_line_slips_through) {
  for (const PolygonSoup& mesh :
       {test::box({1, 2, 3}), test::torus(1, 0.3, 31, 17), test::icosphere(2, 3),
        test::torus_knot(2, 3, 2, 0.7, 0.3, 60, 8)})
    for (int k = 0; k < 3; ++k) {
      const Lines lines(test::soup_of(mesh), line_frame(k), 200);
      std::size_t met = 0;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        int sum = 0;
        for (const LineHit& hit : lines[i]) sum += hit.sign;
        EXPECT_EQ(sum, 0);
        met += !lines[i].empty();
      }
      EXPECT_GT(met, 1000u);
    }
}

// Reference: the sphere's equation, with the error of an icosphere of 20480 triangles.
TEST(Lines, hits_lie_on_the_surface_and_are_signed_by_its_front) {
  const Lines lines(test::soup_of(test::icosphere(1, 5)), line_frame(1), 64);
  std::size_t looked = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    ASSERT_EQ(lines[i].size(), 2u);
    EXPECT_LE(lines[i][0].along, lines[i][1].along);
    EXPECT_EQ(lines[i][0].sign, -1);
    EXPECT_EQ(lines[i][1].sign, 1);
    for (const LineHit& hit : lines[i]) EXPECT_NEAR(lines.point(i, hit.along).norm(), 1, 2e-3);
    ++looked;
  }
  EXPECT_GT(looked, 2000u);
}

// Reference: the same lines through the soup's near part alone.
TEST(Lines, a_raster_smaller_than_the_soup_sees_what_lies_in_it) {
  const Soup soup = test::soup_of(test::box({1e6, 1e6, 2}));
  const Lines lines(soup, Eigen::Matrix3d::Identity(), 16, {-1, -1}, 2);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ASSERT_EQ(lines[i].size(), 2u);
    EXPECT_NEAR(lines[i][0].along, -1, 1e-9);
    EXPECT_NEAR(lines[i][1].along, 1, 1e-9);
  }
}

}  // namespace
}  // namespace sonde
