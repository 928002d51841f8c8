// SPDX-License-Identifier: GPL-3.0-or-later
// The static search where the answer is known by hand: boxes, plates, pegs, triangles, rings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/sketch/sketch.hpp"
#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

// Reference: the balance of moments. A box that lies flat on a plate is held against turns as well,
// though the shortest way out does not turn it.
TEST(StaticSearch, a_box_flat_on_a_plate_is_held_against_turns) {
  const auto box = test::body(test::box({0.1, 0.08, 0.06}));
  const auto plate = test::body(test::box({2, 2, 1}));
  for (const double deep : {0.001, 0.01}) {
    const Separation s =
        separate_static({box, plate}, {Quat::Identity(), Vec3(0.02, -0.01, 0.5 + 0.03 - deep)});
    test::check_separation(*box, *plate, s, "flat");
    EXPECT_NEAR(s.depth, deep, 1e-3 * deep);
    Vec3 moment = Vec3::Zero();
    for (const Contact& c : s.contacts)
      moment += c.multiplier * (c.on_probe - s.separated * box->mass.com).cross(c.normal);
    EXPECT_LT(moment.norm(), 1e-3 * deep * box->mass.radius);
  }
}

// Linked rings that overlap come apart as far as contact, not out of each other.
TEST(StaticSearch, linked_rings) {
  const auto ring = test::body(test::torus(0.08, 0.02, 16, 8));
  const Pose X{Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX())), Vec3(0.125, 0.002, 0)};
  const Separation s = separate_static({ring, ring}, X);
  test::check_separation(*ring, *ring, s, "linked");
  EXPECT_LT(s.depth, 0.0151);  // inwards by what is too far out
}

// Reference: the width of the gap. A peg in a hole that the spacing of the sketches does not show
// comes back to the middle of the hole, not out of it.
TEST(StaticSearch, a_way_out_too_narrow_for_sketches_is_found) {
  const auto wall = [](const Vec3& low, const Vec3& high, PolygonSoup& out) {
    const PolygonSoup box = test::box(high - low);
    const std::size_t first = out.points.size();
    for (const Vec3& x : box.points) out.points.push_back(x + (low + high) / 2);
    for (auto polygon : box.polygons) {
      for (auto& corner : polygon) corner += first;
      out.polygons.push_back(polygon);
    }
  };
  PolygonSoup walls;
  wall({-0.2, -0.1, -0.1}, {-0.0205, 0.1, 0.1}, walls);
  wall({0.0205, -0.1, -0.1}, {0.2, 0.1, 0.1}, walls);
  const auto fixed = test::body(walls), peg = test::body(test::box({0.04, 0.12, 0.12}));
  const Pair bodies(peg, fixed);
  ASSERT_TRUE(bodies.sketches());
  const Separation s = separate_static(bodies, {Quat::Identity(), Vec3(0.001, 0, 0)});
  test::check_separation(*peg, *fixed, s, "peg");
  EXPECT_NEAR(s.depth, 0.0005, 1e-6);
}

TEST(StaticSearch, one_triangle_against_one) {
  const auto flat = test::body({{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const auto upright = test::body({{{-0.2, 0, -0.5}, {0.2, 0, -0.5}, {0, 0, 0.1}}, {{0, 1, 2}}});
  const Separation s = separate_static({upright, flat}, {});
  test::check_separation(*upright, *flat, s, "triangles");
  EXPECT_LE(s.depth, 0.1 * (1 + 1e-3));           // the tip sticks out by that
  EXPECT_LE(s.lower_bound.value_or(1), s.depth);  // it sticks through the other's face
  EXPECT_GT(s.lower_bound.value_or(0), 0.01);
}

TEST(StaticSearch, touching_is_penetrating_with_depth_zero_or_so) {
  const auto cube = test::body(test::box({1, 1, 1}));
  const double radius = cube->mass.radius;
  for (const Vec3& at : {Vec3(1, 0, 0), Vec3(1, 0.25, 0.5), Vec3(1, 1, 0), Vec3(-1, 1, 1)}) {
    const Separation s = separate_static({cube, cube}, {Quat::Identity(), at});
    test::check_separation(*cube, *cube, s, "touching");
    EXPECT_LE(s.depth, 1e-8 * radius) << at.transpose();
    ASSERT_TRUE(s.lower_bound.has_value());
    EXPECT_EQ(*s.lower_bound, 0);
  }
}

// Depth of what lies within a large box, by hand: the nearest face less what reaches past the
// centre. Rotation gains something, so the translational depth is an upper bound, and the depth of
// the centre under the face, over how far a turn can help, a lower one.
TEST(StaticSearch, inside_a_solid) {
  std::mt19937_64 random(7);
  const auto room = test::body(test::box({1, 1, 1}));
  for (const auto& probe :
       {test::body(test::sphere(0.1, 8, 12)), test::body(test::random_soup(random, 12, 0.1)),
        test::body(test::torus(0.08, 0.03, 12, 8))}) {
    const Pose X{test::random_rotation(random), Vec3(0.05, 0.1, 0.2)};
    ASSERT_FALSE(triangles_meet(*probe, *room, Transform(X), Doubt::contact));
    const Separation s = separate_static({probe, room}, X);
    test::check_separation(*probe, *room, s, "inside");
    double highest = 1;
    for (const Triangle& t : probe->soup.triangles)
      for (const std::uint32_t v : t)
        highest = std::min(highest, (X * probe->soup.vertices[v]).z());
    EXPECT_LE(s.depth, (0.5 - highest) * (1 + 1e-3));
    EXPECT_GE(s.depth, 0.3 - 1e-9);  // the centre of mass, 0.3 under the face, must come out
    EXPECT_GT(*s.lower_bound, 0.15);
    const Pose back = inverse(X);
    test::check_separation(*room, *probe, separate_static({room, probe}, back), "around");
  }
}

TEST(StaticSearch, probes_without_thickness) {
  const auto block = test::body(test::box({0.3, 0.3, 0.1}));
  const auto needle = test::body({{{0, 0, 0}, {0.2, 0, 0}, {0.2, 1e-10, 0}}, {{0, 1, 2}}});
  ASSERT_EQ(needle->mass.inertia[0], 0);
  const auto leaf = test::body(test::box({0.1, 0.15, 0}));
  ASSERT_FALSE(leaf->solid);
  std::mt19937_64 random(8);
  for (const auto& probe : {needle, leaf})
    for (int i = 0; i < 6; ++i) {
      Pose X{test::random_rotation(random), Vec3::Zero()};
      X.p = Vec3(0.05, 0.03, 0.045) - X.q * probe->mass.com;
      const Separation s = separate_static({probe, block}, X);
      test::check_separation(*probe, *block, s, "thin probe " + std::to_string(i));
      EXPECT_GE(s.depth, 0.005 - 1e-9);  // the centre of mass is so deep
    }
}

}  // namespace
}  // namespace sonde
