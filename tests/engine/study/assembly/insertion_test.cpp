// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/insertion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/body/body.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double pi = std::numbers::pi;

/// A block with a slot along z, of a width along x, from z = −height up to 0.
std::shared_ptr<const Body> slot(double width, double height, double wall = 0.02) {
  PolygonSoup out;
  const auto add = [&](const Vec3& size, const Vec3& at) {
    const PolygonSoup box = test::box(size);
    const std::size_t first = out.points.size();
    for (const Vec3& x : box.points) out.points.push_back(x + at);
    for (Polygon p : box.polygons) {
      for (std::size_t& corner : p) corner += first;
      out.polygons.push_back(p);
    }
  };
  for (const double side : {-1.0, 1.0})
    add({wall, 0.2, height}, {side * 0.5 * (width + wall), 0, -0.5 * height});
  return test::body(out);
}

Pose above(double x, double z, double tilt = 0) {
  return {Quat(Eigen::AngleAxisd(tilt, Vec3::UnitY())), Vec3(x, 0, z)};
}

// Reference: a peg straight over a slot that is wider goes in; beside it, it stands on the wall.
TEST(Insertion, a_peg_goes_in_where_it_fits_and_stops_on_the_wall_where_not) {
  const Pair pair(test::body(test::box({0.0196, 0.05, 0.1})), slot(0.02, 0.06));
  const auto in = way_along(pair, above(0, 0.06), -Vec3::UnitZ(), 0.05, 0);
  EXPECT_FALSE(first_contact(pair, in));
  const auto on = way_along(pair, above(1e-3, 0.06), -2 * Vec3::UnitZ(), 0.05, 0);
  const auto stop = first_contact(pair, on);
  ASSERT_TRUE(stop);
  EXPECT_NEAR(stop->travel, 0.01, 1e-6 * 0.05);
  EXPECT_NEAR(stop->contact.normal.z(), 1, 1e-6);
  const Insertion found = insertion(pair, in, 50, {});
  EXPECT_FALSE(found.first);
  EXPECT_NEAR(found.steps.back().clearance.distance, 2e-4, 1e-12);
  EXPECT_EQ(found.steps.back().wrench.force.norm(), 0);
}

// Reference: a peg of width d, tilted by θ, whose lower corner is just clear of one wall of a slot
// of width D, meets the edge of the other once so much of it is in that both would touch:
// D = d cos θ + l sin θ for the depth l along the peg of the edge over the corner.
TEST(Insertion, a_tilted_peg_binds_where_both_walls_of_its_slot_meet_it) {
  for (const double tilt : {0.02, 0.05, 0.1}) {
    const double d = 0.019, D = 0.02, long_side = 0.1;
    const Pair pair(test::body(test::box({d, 0.05, long_side})), slot(D, 0.09));
    // The lower corners in the world, relative to the peg's middle.
    const auto corner = [&](double side) {
      return Vec3(above(0, 0, tilt).q * Vec3(side * 0.5 * d, 0, -0.5 * long_side));
    };
    const Vec3 low = corner(1).z() < corner(-1).z() ? corner(1) : corner(-1);
    const Vec3 outer = corner(-1).x() < corner(1).x() ? corner(-1) : corner(1);
    // The outermost corner is a little clear of the wall at x = −D/2.
    const double room = 1e-5;
    const double x = -0.5 * D + room - outer.x();
    const double z0 = 0.02 - low.z();
    const auto way = way_along(pair, above(x, z0, tilt), -Vec3::UnitZ(), 0.08, 0);
    const auto stop = first_contact(pair, way);
    ASSERT_TRUE(stop) << tilt;
    // Along the peg from its outermost corner to where its other side crosses x = D/2.
    const double l = (D - room - d * std::cos(tilt)) / std::sin(tilt);
    // That side begins at the other lower corner; the edge of the slot is at z = 0.
    const Vec3 other = outer == corner(-1) ? corner(1) : corner(-1);
    const double meets = z0 + other.z() + l * std::cos(tilt);
    EXPECT_NEAR(stop->travel, meets, 1e-6 * 0.08) << tilt;
    EXPECT_NEAR(stop->contact.on_fixed.x(), 0.5 * D, 1e-6) << tilt;
    EXPECT_NEAR(stop->contact.on_fixed.z(), 0, 1e-6) << tilt;
    const Insertion found = insertion(pair, way, 40, {.k = 1000});
    ASSERT_TRUE(found.first);
    EXPECT_EQ(found.first->travel, stop->travel);
    for (const InsertionStep& step : found.steps) {
      if (step.travel < stop->travel) {
        EXPECT_EQ(step.held.depth, 0) << step.travel;
      } else if (step.travel > stop->travel + 1e-6) {
        EXPECT_GT(step.held.depth, 0) << step.travel;
      }
    }
    EXPECT_GT(found.steps.back().wrench.force.norm(), 0);
  }
}

// Reference: a wedge of half angle α in a slot: it is stopped where it is as wide as the slot.
TEST(Insertion, a_taper_stops_where_it_is_as_wide_as_its_slot) {
  const double top = 0.03, bottom = 0.01, height = 0.08, D = 0.02;
  PolygonSoup wedge = test::box({1, 0.05, height});
  for (Vec3& x : wedge.points) x.x() *= x.z() > 0 ? top : bottom;
  const Pair pair(test::body(wedge), slot(D, 0.06));
  const auto way = way_along(pair, above(0, 0.06), -Vec3::UnitZ(), 0.1, 0);
  const auto stop = first_contact(pair, way);
  ASSERT_TRUE(stop);
  // Its width at height h over its foot is bottom + (top − bottom) h / height.
  const double h = (D - bottom) / (top - bottom) * height;
  EXPECT_NEAR(stop->travel, 0.06 - 0.5 * height + h, 1e-6 * 0.1);
}

// Reference: a key that turns as it goes down passes a slot only where it is turned along it.
TEST(Insertion, a_screw_turns_by_its_twist) {
  const Pair pair(test::body(test::box({0.01, 0.05, 0.02})), slot(0.02, 0.06));
  const auto way = way_along(pair, above(0, 0.05), -Vec3::UnitZ(), 0.04, 4.5 * pi);
  EXPECT_EQ(way.poses.size(), 10u);
  const Pose end = pose_at(way, pair, 0.04), half = pose_at(way, pair, 0.02);
  EXPECT_NEAR(end.p.z(), 0.01, 1e-15);
  EXPECT_NEAR((end.q * Vec3::UnitX()).dot(Vec3::UnitX()), 0, 1e-12) << "a quarter left over";
  EXPECT_NEAR((half.q * Vec3::UnitX()).dot(Vec3::UnitX()), std::cos(2.25 * pi), 1e-12);
  ASSERT_TRUE(first_contact(pair, way));
  // It is over the walls until its foot is at their top: 0.04 down, but it stays at 0.01: free of
  // them up to there.
  EXPECT_NEAR(first_contact(pair, way)->travel, 0.04, 1e-6 * 0.04);
}

TEST(Insertion, a_recorded_way_is_as_long_as_its_centre_of_mass_goes) {
  const Pair pair(test::body(test::box({0.01, 0.05, 0.02})), slot(0.02, 0.06));
  const auto way = way_through(pair, {above(0, 0.05), above(0.03, 0.05), above(0.03, 0.09)});
  ASSERT_EQ(way.travel.size(), 3u);
  EXPECT_NEAR(way.travel[1], 0.03, 1e-15);
  EXPECT_NEAR(way.travel[2], 0.07, 1e-15);
  EXPECT_NEAR(pose_at(way, pair, 0.05).p.z(), 0.07, 1e-15);
  EXPECT_FALSE(first_contact(pair, way));
}

TEST(Insertion, what_is_no_way_is_refused_with_the_reason) {
  const Pair pair(test::body(test::box({0.01, 0.05, 0.02})), slot(0.02, 0.06));
  const Pose start = above(0, 0.05);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(way_along(pair, start, Vec3::Zero(), 0.1, 0), InputError);
  EXPECT_THROW(way_along(pair, start, {0, nan, 1}, 0.1, 0), InputError);
  EXPECT_THROW(way_along(pair, start, Vec3::UnitZ(), 0, 0), InputError);
  EXPECT_THROW(way_along(pair, start, Vec3::UnitZ(), nan, 0), InputError);
  EXPECT_THROW(way_along(pair, start, Vec3::UnitZ(), 1e9, 0), InputError)
      << "rounded to 1e-7 m, it bound where it goes in";
  EXPECT_NO_THROW(way_along(pair, start, Vec3::UnitZ(), 1e3, 0));
  EXPECT_THROW(way_through(pair, {start}), InputError);
  EXPECT_THROW(way_through(pair, {start, start}), InputError);
  EXPECT_THROW(first_contact(pair, way_along(pair, above(0.012, -0.02), Vec3::UnitZ(), 1, 0)),
               InputError);
}

}  // namespace
}  // namespace sonde
