// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/thin_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "engine/base/error.hpp"
#include "engine/proximity/queries/point_distance.hpp"
#include "tests/engine/offset/prisms.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::optional<ThinPlace> thin_place_of(const PolygonSoup& polygons, double inwards,
                                       const Progress& progress = {}) {
  const auto body = test::body(polygons);
  EXPECT_TRUE(body->solid);
  const Fans fans = find_fans(body->soup, 0);
  const MovedFaces moved = move_faces(body->soup, fans, -inwards, 0);
  const auto found = find_thin_place(*body, body->soup, fans, moved, progress);
  if (found) {
    EXPECT_LT(point_distance(*body, found->at), 1e-12);
  }
  return found;
}

// Reference: by hand, the thickness of a plate, and of the plates of a plus sign.
TEST(ThinPlaces, of_a_plate_is_its_thickness) {
  const PolygonSoup plate = test::box({1, 2, 0.1});
  EXPECT_FALSE(thin_place_of(plate, 0.049));
  for (const double inwards : {0.051, 0.3, 2.0}) {
    const auto found = thin_place_of(plate, inwards);
    ASSERT_TRUE(found) << inwards;
    EXPECT_NEAR(found->thickness, 0.1, 1e-12) << inwards;
    EXPECT_NEAR(std::abs(found->at.z()), 0.05, 1e-12);
  }
}

// Reference: by hand. A block with a square hole has walls of three quarters of the hole's side.
TEST(ThinPlaces, of_a_block_with_a_hole_is_its_wall) {
  const PolygonSoup block = test::block_with_hole(test::rectangle(0.4, 0.4), 1);
  EXPECT_FALSE(thin_place_of(block, 0.149));
  const auto found = thin_place_of(block, 0.16);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->thickness, 0.3, 1e-12);
}

// Reference: by hand. Between the hollow and the outside is a wall of 0.1; the hollow grows into
// it, crosses it, or is through it altogether.
TEST(ThinPlaces, of_a_hollow_is_the_wall_around_it) {
  const PolygonSoup hollow = test::together(
      test::box({1, 1, 1}), test::inside_out(test::box({0.2, 0.2, 0.2})), {0, 0, 0.3});
  EXPECT_FALSE(thin_place_of(hollow, 0.049));
  for (const double inwards : {0.051, 0.09, 0.19}) {
    const auto found = thin_place_of(hollow, inwards);
    ASSERT_TRUE(found) << inwards;
    EXPECT_NEAR(found->thickness, 0.1, 1e-12) << inwards;
  }
}

// Reference: by hand. A hollow beside the middle, with walls of 0.05 to 0.15 around it, has grown
// through all of them: nothing crosses anything.
TEST(ThinPlaces, of_a_hollow_that_is_through_all_its_walls_is_one_of_these) {
  const PolygonSoup shell = test::together(
      test::box({1, 1, 1}), test::inside_out(test::box({0.8, 0.8, 0.8})), {0, 0, 0.05});
  EXPECT_FALSE(thin_place_of(shell, 0.024));
  const auto found = thin_place_of(shell, 0.2);
  ASSERT_TRUE(found);
  EXPECT_GE(found->thickness, 0.05 - 1e-12);
  EXPECT_LE(found->thickness, 0.15 + 1e-12);
}

// Reference: by hand. Of walls of 0.25 and 0.35 on two sides of a hole, it is the thinner one.
TEST(ThinPlaces, of_two_walls_is_the_thinner_one) {
  PolygonSoup block = test::block_with_hole(test::rectangle(0.4, 0.4), 1);
  for (std::size_t i = 0; i < 8; ++i) block.points[i].x() += 0.05;  // the hole's
  EXPECT_FALSE(thin_place_of(block, 0.124));
  const auto found = thin_place_of(block, 0.18);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->thickness, 0.25, 1e-12);
}

// Parts that fill space each by itself are one to begin with.
TEST(ThinPlaces, parts_that_go_through_each_other_may_go_on_doing_so) {
  const PolygonSoup bars =
      test::together(test::box({2, 0.4, 0.4}), test::box({0.4, 2, 0.4}), {0.03, 0.02, 0.05});
  EXPECT_FALSE(thin_place_of(bars, 0.01));
}

TEST(ThinPlaces, can_be_cancelled) {
  EXPECT_THROW(thin_place_of(test::box({1, 2, 0.1}), 0.01, [](double) { return false; }),
               Cancelled);
}

}  // namespace
}  // namespace sonde
