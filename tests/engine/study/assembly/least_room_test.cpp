// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/least_room.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "engine/body/body.hpp"
#include "engine/study/assembly/insertion.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// Two boxes as one body, to either side of x = 0 and of a gap between them.
std::shared_ptr<const Body> gate(double gap, const Vec3& size) {
  PolygonSoup out;
  for (const double side : {-1.0, 1.0}) {
    const PolygonSoup box = test::box(size);
    const std::size_t first = out.points.size();
    for (const Vec3& x : box.points)
      out.points.push_back(x + Vec3(side * 0.5 * (gap + size.x()), 0, 0));
    for (Polygon p : box.polygons) {
      for (std::size_t& corner : p) corner += first;
      out.polygons.push_back(p);
    }
  }
  return test::body(out);
}

Pose turned(double x, double z, double turn = 0) {
  return {Quat(Eigen::AngleAxisd(turn, Vec3::UnitY())), Vec3(x, 0, z)};
}

LeastRoom of_start(const Pair& pair, const InsertionPath& way) {
  LeastRoom out;
  out.clearance = distance(pair, way.poses.front()).distance;
  out.X_FM = way.poses.front();
  return out;
}

LeastRoom searched(const Pair& pair, const InsertionPath& way) {
  return least_room(pair, way, of_start(pair, way), work_of_least_room);
}

// Reference: by hand. The plate is so thin that no row of the table is beside it.
TEST(LeastRoom, a_thin_plate_that_is_passed_between_two_steps_counts) {
  const Pair pair(test::body(test::box({0.018, 0.018, 6e-4})), gate(0.0182, {0.05, 0.1, 2e-4}));
  const auto way = way_along(pair, turned(0, 0.3552), -Vec3::UnitZ(), 0.6, 0);
  const Insertion found = insertion(pair, way, 200, {});
  ASSERT_FALSE(found.first);
  EXPECT_TRUE(found.room.complete);
  EXPECT_EQ(found.room.searched, 0.6);
  EXPECT_NEAR(found.room.clearance, 1e-4, 1e-3 * 1e-4);
  EXPECT_NEAR(found.room.travel, 0.3552, 4e-4);
  EXPECT_EQ(distance(pair, found.room.X_FM).distance, found.room.clearance);
}

// Reference: the gates' own gaps. Each is passed between two rows, and the narrowest is the last.
TEST(LeastRoom, the_narrowest_of_several_gates_is_found) {
  PolygonSoup gates;
  for (const double k : {0.0, 1.0, 2.0, 3.0, 4.0})
    for (const double side : {-1.0, 1.0}) {
      const PolygonSoup box = test::box({0.05, 0.1, 1e-4});
      const std::size_t first = gates.points.size();
      const double inner = 0.01 + 1e-4 * (k == 3 ? 0.5 : 1 + 0.1 * k);
      for (const Vec3& x : box.points)
        gates.points.push_back(x + Vec3(side * (inner + 0.025), 0, -0.0371 * (k + 1)));
      for (Polygon p : box.polygons) {
        for (std::size_t& corner : p) corner += first;
        gates.polygons.push_back(p);
      }
    }
  const Pair pair(test::body(test::box({0.02, 0.02, 1e-4})), test::body(gates));
  const auto way = way_along(pair, turned(0, 0.01), -Vec3::UnitZ(), 0.25, 0);
  const LeastRoom found = searched(pair, way);
  EXPECT_TRUE(found.complete);
  EXPECT_NEAR(found.clearance, 5e-5, 1e-3 * 5e-5);
  EXPECT_NEAR(found.travel, 0.01 + 4 * 0.0371, 1.1e-4);
}

// Reference: by hand. A bound by the speed of points alone would take a million steps here.
TEST(LeastRoom, a_long_slot_with_the_same_room_throughout_is_little_work) {
  const Pair pair(test::body(test::box({0.0198, 0.05, 0.1})), gate(0.02, {0.02, 0.2, 0.5}));
  const auto way = way_along(pair, turned(0, 0.305), -Vec3::UnitZ(), 0.5, 0);
  const LeastRoom found = least_room(pair, way, of_start(pair, way), 1'000'000);
  EXPECT_TRUE(found.complete);
  EXPECT_NEAR(found.clearance, 1e-4, 1e-12);
}

// Reference: the corner of a square with half side h is h √2 aside where it has turned by 45°.
TEST(LeastRoom, a_turn_on_the_spot_counts_between_its_ends) {
  const double h = 0.01, room = 2e-4;
  const Pair pair(test::body(test::box({2 * h, 0.02, 2 * h})),
                  gate(2 * (h * std::sqrt(2.0) + room), {0.05, 0.1, 0.2}));
  const auto way = way_through(pair, {turned(0, 0), turned(0, 0, 0.5 * std::numbers::pi),
                                      turned(0, 0.03, 0.5 * std::numbers::pi)});
  const LeastRoom found = searched(pair, way);
  EXPECT_TRUE(found.complete);
  EXPECT_NEAR(found.clearance, room, 1e-3 * room);
  EXPECT_EQ(found.travel, 0);
  EXPECT_NEAR(std::abs(found.X_FM.q.y()), std::sin(std::numbers::pi / 8), 1e-2);
}

// Reference: distances at many samples, of which none may be below what was proved.
TEST(LeastRoom, no_sample_of_a_free_way_has_less_room_than_was_proved) {
  std::mt19937_64 random(5);
  const auto knot = test::body(test::torus_knot(2, 3, 0.05, 0.02, 0.008, 60, 8));
  const auto ring = test::body(test::torus(0.03, 0.005, 24, 10));
  const auto rock = test::body(test::random_soup(random, 12, 0.03));
  int tried = 0;
  for (int i = 0; tried < 24 && i < 400; ++i) {
    const Pair pair(i % 2 ? rock : ring, knot);
    const Pose start{test::random_rotation(random), test::random_in_ball(random, 0.15)};
    if (touch(pair, start)) continue;
    const auto way =
        way_along(pair, start, test::random_in_ball(random, 1), 0.15, test::uniform(random, -6, 6));
    if (first_contact(pair, way)) continue;
    ++tried;
    const LeastRoom found = searched(pair, way);
    ASSERT_TRUE(found.complete) << i;
    EXPECT_LE(found.tolerance, std::max(1e-3 * found.clearance, 1e-8 * pair.probe().mass.radius));
    EXPECT_EQ(distance(pair, found.X_FM).distance, found.clearance);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 2000; ++k)
      least = std::min(least, distance(pair, pose_at(way, pair, 0.15 * k / 2000)).distance);
    EXPECT_GE(least, found.clearance - found.tolerance) << i;
  }
  EXPECT_EQ(tried, 24);
}

TEST(LeastRoom, where_the_work_ends_it_says_how_far_it_searched) {
  const Pair pair(test::body(test::box({0.018, 0.018, 6e-4})), gate(0.0182, {0.05, 0.1, 2e-4}));
  const auto way = way_along(pair, turned(0, 0.3552), -Vec3::UnitZ(), 0.6, 0);
  const LeastRoom found = least_room(pair, way, of_start(pair, way), 30'000);
  EXPECT_FALSE(found.complete);
  EXPECT_GT(found.searched, 0);
  EXPECT_LT(found.searched, 0.6);
}

TEST(LeastRoom, a_way_that_is_blocked_has_the_room_of_its_rows) {
  const Pair pair(test::body(test::box({0.018, 0.018, 6e-4})), gate(0.0178, {0.05, 0.1, 2e-4}));
  const auto way = way_along(pair, turned(0, 0.1), -Vec3::UnitZ(), 0.2, 0);
  const Insertion found = insertion(pair, way, 20, {});
  ASSERT_TRUE(found.first);
  EXPECT_LT(found.room.clearance, 1e-8);
  EXPECT_EQ(found.room.searched, found.first->travel);
  EXPECT_TRUE(found.room.complete);
}

TEST(LeastRoom, the_search_can_be_stopped) {
  const Pair pair(test::body(test::box({0.018, 0.018, 6e-4})), gate(0.0182, {0.05, 0.1, 2e-4}));
  const auto way = way_along(pair, turned(0, 0.3552), -Vec3::UnitZ(), 0.6, 0);
  EXPECT_THROW(
      least_room(pair, way, of_start(pair, way), work_of_least_room, [](double) { return false; }),
      Cancelled);
}

}  // namespace
}  // namespace sonde
