// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/intersect.hpp"

#include <gtest/gtest.h>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

// Reference: exact predicates on every pair of triangles.
TEST(Intersect, triangles_meet_is_what_exact_predicates_say_of_all_pairs) {
  std::mt19937_64 random(1);
  for (const auto& pair : test::body_pairs(11)) {
    int meeting = 0, erring = 0;
    constexpr int poses = 150;
    for (int i = 0; i < poses; ++i) {
      const Transform X(test::random_pose(random, *pair.a, *pair.b, 1.1));
      const bool expected = test::any_pair_meets(*pair.a, *pair.b, X);
      EXPECT_EQ(triangles_meet(*pair.a, *pair.b, X, Doubt::exact), expected) << pair.name << i;
      const bool contact = triangles_meet(*pair.a, *pair.b, X, Doubt::contact);
      EXPECT_GE(contact, expected) << pair.name << i;
      erring += contact != expected;
      meeting += expected;
    }
    EXPECT_GT(meeting, poses / 20) << pair.name;
    EXPECT_LT(meeting, poses * 19 / 20) << pair.name;
    EXPECT_LE(erring, 1) << pair.name;
  }
}

// Touching at a face, an edge or a corner is contact, and one rounding step off it is not.
TEST(Intersect, touching_meets_and_the_next_number_beyond_does_not) {
  const auto unit = test::body(test::box({1, 1, 1}));
  struct Case {
    Vec3 at;
    int axis;
  };
  for (const Case& c : {Case{{0, 0, 1}, 2}, Case{{0.25, 0.5, 1}, 2}, Case{{1, 0, 1}, 0},
                        Case{{1, 1, 1}, 1}, Case{{-1, 0.125, 0}, 0}}) {
    Transform X;
    X.p = c.at;
    for (const Doubt doubt : {Doubt::exact, Doubt::contact})
      EXPECT_TRUE(triangles_meet(*unit, *unit, X, doubt)) << c.at.transpose();
    // The smallest number that can be seen after adding the corner's ½.
    X.p[c.axis] *= 1 + 0x1p-51;
    EXPECT_FALSE(triangles_meet(*unit, *unit, X, Doubt::exact)) << c.at.transpose();
    EXPECT_TRUE(triangles_meet(*unit, *unit, X, Doubt::contact)) << c.at.transpose();
    X.p[c.axis] *= 1 + 1e-13;
    EXPECT_FALSE(triangles_meet(*unit, *unit, X, Doubt::contact)) << c.at.transpose();
  }
}

// Reference: all pairs, then the winding number of every vertex by solid angles.
TEST(Intersect, overlap_is_what_brute_force_says) {
  std::mt19937_64 random(2);
  std::vector<test::BodyPair> pairs = test::body_pairs(12);
  const auto big = test::body(test::box({1, 0.8, 0.9}));
  const auto small_soup = test::body(test::random_soup(random, 20, 0.2));
  const auto ring = test::body(test::torus(0.08, 0.03, 10, 6));
  pairs.push_back({"surface in solid", small_soup, big});
  pairs.push_back({"solid in solid", ring, big});
  pairs.push_back({"solid round solid", big, ring});
  pairs.push_back({"solid round surface", big, small_soup});
  for (const auto& pair : pairs) {
    int contained = 0, overlapping = 0;
    constexpr int poses = 60;
    for (int i = 0; i < poses; ++i) {
      const Transform X(test::random_pose(random, *pair.a, *pair.b, 1.0));
      const bool expected = !test::is_free(*pair.a, *pair.b, X);
      EXPECT_EQ(overlap(*pair.a, *pair.b, X, Doubt::exact), expected) << pair.name << i;
      EXPECT_GE(overlap(*pair.a, *pair.b, X, Doubt::contact), expected) << pair.name << i;
      overlapping += expected;
      contained += expected && !triangles_meet(*pair.a, *pair.b, X, Doubt::exact);
    }
    EXPECT_GT(overlapping, 2) << pair.name;
    if (pair.name.starts_with("solid ") || pair.name.starts_with("surface in")) {
      EXPECT_GT(contained, 2) << pair.name;
    }
  }
}

void append(PolygonSoup& to, const PolygonSoup& more, bool reversed = false) {
  const std::size_t base = to.points.size();
  to.points.insert(to.points.end(), more.points.begin(), more.points.end());
  for (auto polygon : more.polygons) {
    if (reversed) std::reverse(polygon.begin(), polygon.end());
    for (std::size_t& i : polygon) i += base;
    to.polygons.push_back(polygon);
  }
}

Transform at(double x, double y, double z) {
  Transform X;
  X.p = Vec3(x, y, z);
  return X;
}

// Containment by hand, at places where no triangles meet.
TEST(Intersect, containment_by_hand) {
  const auto cube = test::body(test::box({0.1, 0.1, 0.1}));
  const auto dot = test::body(test::box({0.04, 0.04, 0.04}));
  const auto sheet = test::body({{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}}});
  PolygonSoup hollow_soup = test::box({1, 1, 1});
  append(hollow_soup, test::box({0.5, 0.5, 0.5}), true);
  const auto hollow = test::body(hollow_soup);
  ASSERT_TRUE(hollow->solid) << hollow->why;
  PolygonSoup shells_soup = hollow_soup;  // and a solid one within the hollow
  append(shells_soup, test::box({0.3, 0.3, 0.3}));
  const auto shells = test::body(shells_soup);
  PolygonSoup twice_soup = test::box({1, 1, 1});  // two that cross: winding number 2 in the middle
  append(twice_soup, test::scaled_and_moved(test::box({1, 1, 1}), 1, {0.5, 0.25, 0.125}));
  const auto twice = test::body(twice_soup);
  ASSERT_TRUE(twice->solid) << twice->why;
  PolygonSoup two_soup = test::scaled_and_moved(test::box({0.1, 0.1, 0.1}), 1, {5, 0, 0});
  append(two_soup, test::box({0.1, 0.1, 0.1}));
  const auto two = test::body(two_soup);

  struct Case {
    const char* what;
    std::shared_ptr<const Body> a, b;
    Transform X;
    bool overlapping;
  };
  const std::vector<Case> cases = {
      {"in the hollow", cube, hollow, at(0, 0, 0), false},
      {"a sheet in the hollow", sheet, hollow, at(0, 0, 0), false},
      {"in the wall", cube, hollow, at(0, 0, 0.375), true},
      {"a sheet in the wall", sheet, hollow, at(0, 0, 0.375), true},
      {"in the inmost shell", cube, shells, at(0.05, 0, 0), true},
      {"between hollow and inmost shell", dot, shells, at(0.2, 0, 0), false},
      {"where the winding number is two", cube, twice, at(0.25, 0.125, 0.0625), true},
      {"where it is one", cube, twice, at(-0.4, -0.4, -0.4), true},
      {"outside both", cube, twice, at(-0.4, 0.7, 0), false},
      {"the second of two components inside", two, hollow, at(0, 0, 0.375), true},
      {"the first of two components inside", two, hollow, at(-5, 0, 0.375), true},
      {"neither", two, hollow, at(2, 0, 0), false},
      {"a solid about a sheet", hollow, sheet, at(0, 0, 0.375), true},
      {"a hollow about a sheet", hollow, sheet, at(0, 0, 0), false},
      {"sheets have no inside", sheet, sheet, at(0, 0, 0.01), false},
  };
  for (const Case& c : cases) {
    ASSERT_FALSE(triangles_meet(*c.a, *c.b, c.X, Doubt::contact)) << c.what;
    EXPECT_EQ(overlap(*c.a, *c.b, c.X, Doubt::exact), c.overlapping) << c.what;
    EXPECT_EQ(!test::is_free(*c.a, *c.b, c.X), c.overlapping) << c.what;
  }
}

TEST(Intersect, in_doubt_as_contact_does_not_allocate) {
  std::mt19937_64 random(3);
  const auto pairs = test::body_pairs(13);
  const auto unit = test::body(test::box({1, 1, 1}));
  int meeting = 0;
  test::AllocationCounter counter;
  for (const auto& pair : pairs)
    for (int i = 0; i < 20; ++i) {
      const Transform X(test::random_pose(random, *pair.a, *pair.b, 1.1));
      meeting += overlap(*pair.a, *pair.b, X, Doubt::contact);
    }
  meeting += triangles_meet(*unit, *unit, at(0, 0, 1), Doubt::contact);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
  EXPECT_GT(meeting, 5);
}

}  // namespace
}  // namespace sonde
