// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/first_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "engine/queries/pair_queries.hpp"
#include "engine/study/assembly/insertion.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Two walls whose faces are x = −width/2 and x = width/2, from z = −height up to 0.
std::shared_ptr<const Body> two_walls(double width, double height) {
  const Vec3 size(2 * width, 4 * width, height);
  const Vec3 aside(0.5 * (width + size.x()), 0, 0), down(0, 0, -0.5 * height);
  return test::body(test::joined(test::placed(test::box(size), down - aside),
                                 test::placed(test::box(size), down + aside)));
}

/// What was found against what was reckoned: the free part ends before it, and the tolerance
/// reaches beyond it. That is 1e-9 of the travel, or some more where rounding of the gap is more.
void expect_first(const std::optional<FirstContact>& first, double wanted, double travel) {
  ASSERT_TRUE(first);
  const double rounding = 1e-10 * travel;
  EXPECT_LE(first->travel, wanted + rounding);
  EXPECT_GE(first->travel + first->tolerance, wanted - rounding);
  EXPECT_LE(first->tolerance, 1e-8 * travel);
}

// Reference: by hand. A peg of width d, tilted by θ, whose lower corner is clear of one wall by
// `room`, meets the edge of the other where D − room = d cos θ + l sin θ, with l along the peg.
TEST(FirstContact, a_peg_tilted_by_little_is_placed_as_well_as_any) {
  struct Case {
    double degrees, room, length;
  };
  for (const Case& c : {Case{0.02, 5e-6, 0.06},
                        {0.005, 1e-6, 0.06},
                        {0.05, 1.27e-5, 0.0508},
                        {0.01, 2e-5, 0.5},
                        {0.02, 1e-7, 0.004}}) {
    const double d = 0.25 * c.length, D = d + 2 * c.room, tilt = c.degrees * degree;
    const Pair pair(test::body(test::box({d, d, c.length})), two_walls(D, 1.2 * c.length));
    const Quat q(Eigen::AngleAxisd(tilt, Vec3::UnitY()));
    const Vec3 outer = q * Vec3(-0.5 * d, 0, -0.5 * c.length);
    const Vec3 other = q * Vec3(0.5 * d, 0, -0.5 * c.length);
    const double room = 0.2 * c.room, z = 0.6 * c.length, travel = 0.9 * c.length;
    const Pose start{q, Vec3(room - 0.5 * D - outer.x(), 0, z)};
    const double l = (D - room - d * std::cos(tilt)) / std::sin(tilt);
    const double wanted = z + other.z() + l * std::cos(tilt);
    const auto first = first_contact(pair, way_along(pair, start, -Vec3::UnitZ(), travel, 0));
    SCOPED_TRACE(c.degrees);
    expect_first(first, wanted, travel);
    // The side of the peg lies on the edge: its direction, well above rounding.
    EXPECT_NEAR(first->contact.normal.x(), -std::cos(tilt), 1e-9);
    EXPECT_NEAR(first->contact.on_fixed.x(), 0.5 * D, 1e-9);
    EXPECT_NEAR(first->contact.on_fixed.z(), 0, 1e-6 * c.length);
    EXPECT_FALSE(touch(pair, first->X_FM));
  }
}

// Reference: by hand. A wedge stops where it is as wide as its slot, half-way up.
TEST(FirstContact, a_shallow_taper_is_placed_as_well_as_any) {
  struct Case {
    double wider, length;
  };
  for (const Case& c :
       {Case{1e-5, 0.05}, {5e-5, 0.1}, {1.27e-5, 0.0508}, {2e-3, 0.3}, {1e-7, 0.01}}) {
    const double D = 0.2 * c.length, travel = 0.9 * c.length;
    PolygonSoup wedge = test::box({1, 0.1 * c.length, c.length});
    for (Vec3& x : wedge.points) x.x() *= x.z() > 0 ? D + c.wider : D - c.wider;
    const Pair pair(test::body(wedge), two_walls(D, 1.2 * c.length));
    const Pose start{Quat::Identity(), Vec3(0, 0, 0.55 * c.length)};
    SCOPED_TRACE(c.wider);
    expect_first(first_contact(pair, way_along(pair, start, -Vec3::UnitZ(), travel, 0)),
                 0.55 * c.length, travel);
  }
}

// Reference: the peg is narrower than its slot, by less than the gap at which one sweep stops.
TEST(FirstContact, the_least_of_rooms_lets_a_peg_through) {
  const double D = 0.02, travel = 0.05;
  for (const double room : {1e-10, 1e-11, 1e-12}) {
    const Pair pair(test::body(test::box({D - 2 * room, 0.03, 0.1})), two_walls(D, 0.06));
    const Pose start{Quat::Identity(), Vec3(0, 0, 0.06)};
    EXPECT_FALSE(first_contact(pair, way_along(pair, start, -Vec3::UnitZ(), travel, 0))) << room;
  }
}

// Reference: by hand. A key of d by w, turned by φ, is as wide as d cos φ + w sin φ.
TEST(FirstContact, a_turn_in_one_place_is_part_of_a_path) {
  const double D = 0.02, d = 0.0196, w = 0.03;
  const Pair pair(test::body(test::box({d, w, 0.01})), two_walls(D, 0.06));
  const auto at = [](double z, double turn) {
    return Pose{Quat(Eigen::AngleAxisd(turn, Vec3::UnitZ())), Vec3(0, 0, z)};
  };
  const auto way = way_through(pair, {at(0.02, 0), at(-0.01, 0), at(-0.01, 0.1), at(-0.05, 0.1)});
  const auto first = first_contact(pair, way);
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->travel, 0.03, 1e-15);
  EXPECT_LE(first->tolerance, 1e-9 * 0.07);
  // d cos φ + w sin φ = hypot(d, w) cos(φ − atan2(w, d)) = D.
  const double turn = std::atan2(w, d) - std::acos(D / std::hypot(d, w));
  EXPECT_NEAR(2 * first->X_FM.q.z(), 2 * std::sin(0.5 * turn), 1e-9);
}

/// The sides of a bar of 2a by 2b about z that turns once on 20 mm, from z = low up to high.
std::shared_ptr<const Body> twisted_sides(double a, double b, double low, double high) {
  constexpr std::size_t layers = 240;
  PolygonSoup out;
  for (std::size_t i = 0; i <= layers; ++i) {
    const double z = low + (high - low) * static_cast<double>(i) / layers;
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * z / 0.02, Vec3::UnitZ());
    for (const Vec3& corner : {Vec3(a, b, 0), Vec3(-a, b, 0), Vec3(-a, -b, 0), Vec3(a, -b, 0)})
      out.points.push_back(turn * corner + Vec3(0, 0, z));
  }
  for (std::size_t i = 0; i < 4 * layers; ++i) {
    const std::size_t next = i % 4 == 3 ? i - 3 : i + 1;
    out.polygons.push_back({i, next, next + 4});
    out.polygons.push_back({i, next + 4, i + 4});
  }
  return test::body(out);
}

// Reference: the bar is smaller than the bore by more than its facets are off the screw, and goes
// through; turned by more than the screw, it meets the bore where one sweep of all of it says.
TEST(FirstContact, a_screw_is_swept_in_slices_and_can_be_stopped_between_them) {
  const Pair pair(twisted_sides(0.006, 0.003, -0.006, 0.006),
                  twisted_sides(0.0062, 0.0032, -0.01, 0.006));
  const auto way = [&](double excess) {
    const double twist = -0.2 * std::numbers::pi * (1 + excess);
    return way_along(pair, {}, -Vec3::UnitZ(), 0.002, -twist);
  };
  int calls = 0;
  EXPECT_FALSE(first_contact(pair, way(0), [&](double) { return ++calls > 0; }));
  EXPECT_EQ(way(0).poses.size(), 2u) << "one piece";
  EXPECT_GT(calls, 4);
  const int all = calls;
  calls = 0;
  EXPECT_THROW(first_contact(pair, way(0), [&](double) { return ++calls < 4; }), Cancelled);
  EXPECT_EQ(calls, 4);
  EXPECT_LT(calls, all);
  calls = 0;
  EXPECT_THROW(insertion(pair, way(0), 2, {}, [&](double) { return ++calls < 4; }), Cancelled);
  const InsertionPath over = way(0.5);
  const auto first = first_contact(pair, over);
  ASSERT_TRUE(first);
  const SweptPath whole = sweep(pair, over.poses.front(), over.poses.back());
  EXPECT_NEAR(first->travel, whole.free * 0.002, 1e-7 * 0.002);
}

TEST(FirstContact, what_leads_nowhere_is_refused) {
  const Pair pair(test::body(test::box({0.01, 0.05, 0.02})), two_walls(0.02, 0.06));
  const auto way = [&](const Vec3& to) {
    return way_through(pair, {{Quat::Identity(), Vec3(0, 0, 0.05)}, {Quat::Identity(), to}});
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  InsertionPath broken = way(Vec3::Zero());
  broken.poses.back().p.z() = nan;
  EXPECT_THROW(first_contact(pair, broken), InputError);
  EXPECT_THROW(first_contact(pair, way({0, 0, -1e151})), InputError);
  EXPECT_THROW(first_contact(pair, way({0.005, 0, -1e15})), InputError);
}

}  // namespace
}  // namespace sonde
