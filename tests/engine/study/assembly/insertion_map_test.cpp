// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/insertion_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/error.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A cube of 0.1 m over another, 20 mm above it; it is to go down by 50 mm.
struct CubeOverCube {
  Pair pair{test::body(test::box({0.1, 0.1, 0.1})), test::body(test::box({0.1, 0.1, 0.1}))};
  InsertionPath way =
      way_along(pair, {Quat::Identity(), Vec3(0, 0, 0.12)}, -Vec3::UnitZ(), 0.05, 0);
  InsertionMap map{.axis = -Vec3::UnitZ(),
                   .lateral = Vec3::UnitX(),
                   .largest_offset = 0.12,
                   .largest_tilt = 0.1,
                   .offsets = 3,
                   .tilts = 5};
};

// Reference: by hand. Tilted by θ, the lowest corner is 50 mm (cos θ + |sin θ|) under the middle.
TEST(InsertionMap, free_travel_is_as_reckoned_by_hand) {
  const CubeOverCube scene;
  const auto free = free_travels(scene.pair, scene.way, scene.map, 2);
  ASSERT_EQ(free.size(), 15u);
  for (std::size_t j = 0; j < 5; ++j) {
    const double tilt = scene.map.tilt(j);
    EXPECT_NEAR(tilt, -0.1 + 0.05 * static_cast<double>(j), 1e-15);
    const double under = 0.05 * (std::cos(tilt) + std::abs(std::sin(tilt)));
    EXPECT_NEAR(free[5 + j], 0.12 - 0.05 - under, 1e-7) << tilt;
    EXPECT_EQ(free[j], 0.05) << "beside the other";
    EXPECT_EQ(free[10 + j], 0.05);
  }
  EXPECT_EQ(free, free_travels(scene.pair, scene.way, scene.map, 1)) << "on any number of threads";
}

TEST(InsertionMap, a_point_that_overlaps_where_it_begins_has_less_than_none) {
  CubeOverCube scene;
  scene.way = way_along(scene.pair, {Quat::Identity(), Vec3(0, 0, 0.101)}, -Vec3::UnitZ(), 0.05, 0);
  const auto free = free_travels(scene.pair, scene.way, scene.map, 1);
  EXPECT_LT(free[5], 0);
  EXPECT_NEAR(free[7], 0.001, 1e-9);
}

TEST(InsertionMap, the_lateral_direction_is_square_to_the_axis) {
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.6, -0.64, 0.48)}) {
    EXPECT_NEAR(lateral_to(axis).norm(), 1, 1e-15);
    EXPECT_NEAR(lateral_to(axis).dot(axis), 0, 1e-15);
  }
}

// Reference: by hand, 3-4-5 triangles.
TEST(InsertionMap, of_a_direction_what_is_square_to_the_axis_is_taken) {
  const auto square = square_to({0, 0.6, 0.8}, {0, 10, 0});
  ASSERT_TRUE(square);
  EXPECT_LT((*square - Vec3(0, 0.8, -0.6)).norm(), 1e-15);
  const auto of_little = square_to({0, 0, 1}, {1e-200, 0, 0});
  ASSERT_TRUE(of_little);
  EXPECT_EQ(*of_little, Vec3(Vec3::UnitX()));
  EXPECT_FALSE(square_to({0, 0, 1}, {0, 0, -2}));
  EXPECT_FALSE(square_to({0, 0, 1}, Vec3::Zero()));
  EXPECT_FALSE(square_to({0, 0, 1}, {NAN, 0, 0}));
  EXPECT_FALSE(square_to({0, 0, 1}, {INFINITY, 0, 0}));
}

TEST(InsertionMap, ranges_without_sense_are_refused_and_it_is_cancelled) {
  CubeOverCube scene;
  const auto run = [&] {
    return free_travels(scene.pair, scene.way, scene.map, 2, [](double) { return false; });
  };
  EXPECT_THROW(run(), Cancelled);
  for (const double range : {-1.0, std::nan("")}) {
    scene.map.largest_tilt = range;
    EXPECT_THROW(run(), InputError);
  }
  scene.map.largest_tilt = 0;
  scene.map.tilts = 0;
  EXPECT_THROW(run(), InputError);
}

}  // namespace
}  // namespace sonde
