// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/restricted/separate_within.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/queries/pair_queries.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Pose at(const Vec3& p) { return {Quat::Identity(), p}; }
Pair boxes(const Vec3& probe, const Vec3& fixed) {
  return {test::body(test::box(probe)), test::body(test::box(fixed))};
}
PolygonSoup joined(PolygonSoup a, const PolygonSoup& b) {
  const std::size_t first = a.points.size();
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (std::vector<std::size_t> polygon : b.polygons) {
    for (std::size_t& i : polygon) i += first;
    a.polygons.push_back(polygon);
  }
  return a;
}
Separation along(const Pair& pair, const Pose& X, const std::vector<Vec3>& directions) {
  return separate_along(pair, X, directions);
}

// Reference: where the faces of two boxes pass each other.
TEST(SeparateWithin, boxes_come_apart_where_their_faces_pass_each_other) {
  const Pair pair = boxes({0.2, 0.3, 0.1}, {0.5, 0.4, 0.7});
  const Vec3 p(0.13, -0.04, 0.21);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      const Separation found = along(pair, at(p), {sign * Vec3::Unit(axis)});
      const double half = 0.5 * (Vec3(0.2, 0.3, 0.1) + Vec3(0.5, 0.4, 0.7))[axis];
      ASSERT_EQ(found.status, Status::penetrating);
      EXPECT_NEAR(found.depth, half - sign * p[axis], 1e-12);
      EXPECT_FALSE(touch(pair, found.separated));
      EXPECT_LT((found.separated.p - p - found.depth * sign * Vec3::Unit(axis)).norm(), 1e-12);
      ASSERT_EQ(found.contacts.size, 1);
      EXPECT_NEAR(found.contacts[0].normal[axis], sign, 1e-6);
      EXPECT_NEAR(found.contacts[0].multiplier, found.depth, 1e-6 * found.depth);
    }
  const Separation nearest =
      along(pair, at(p),
            {-Vec3::UnitX(), 5 * Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY(), Vec3::UnitZ()});
  EXPECT_NEAR(nearest.depth, 0.5 * 0.8 - 0.21, 1e-12) << "the nearest, whatever their lengths";
}

TEST(SeparateWithin, a_slot_that_is_hardly_wider_is_not_stepped_over) {
  // Two slabs 0.05 apart, and a box that fits between them to a tenth of a micrometre.
  const auto slab = [](double x) {
    return test::scaled_and_moved(test::box({0.3, 0.2, 0.2}), 1, Vec3(x, 0, 0));
  };
  const Pair pair(test::body(test::box({0.05 - 1e-7, 0.06, 0.06})),
                  test::body(joined(slab(-0.15), slab(0.15 + 0.05))));
  const Separation found = along(pair, at({-0.11, 0.01, 0.02}), {Vec3::UnitX()});
  ASSERT_EQ(found.status, Status::penetrating);
  EXPECT_NEAR(found.depth, 0.11 + 0.025 - 0.5e-7, 1e-12);
  EXPECT_FALSE(touch(pair, found.separated));
}

TEST(SeparateWithin, a_box_inside_a_solid_or_in_the_wall_of_a_hollow_one_comes_out_where_it_can) {
  const Pair solid = boxes({0.01, 0.01, 0.01}, {1, 1, 1});
  EXPECT_NEAR(along(solid, at({0.2, 0, 0}), {Vec3::UnitX()}).depth, 0.305, 1e-12);
  PolygonSoup hollow = test::box({0.5, 0.5, 0.5});
  for (auto& polygon : hollow.polygons) std::ranges::reverse(polygon);
  const Pair shell(test::body(test::box({0.01, 0.01, 0.01})),
                   test::body(joined(test::box({1, 1, 1}), hollow)));
  // From the middle of a wall of 0.25: into the cavity, as far as out of it.
  EXPECT_NEAR(along(shell, at({0.36, 0, 0}), {Vec3::UnitX()}).depth, 0.5 + 0.005 - 0.36, 1e-12);
  EXPECT_NEAR(along(shell, at({0.36, 0, 0}), {-Vec3::UnitX()}).depth, 0.36 - 0.245, 1e-12);
}

/// The first of many poses along a way that is free, by touch() alone: the least free place is no
/// further, and within a step of it unless a gap is narrower.
double first_free(const Pair& pair, const auto& pose_at, double most, int steps) {
  for (int i = 1; i <= steps; ++i)
    if (!touch(pair, pose_at(most * i / steps))) return most * i / steps;
  return std::numeric_limits<double>::infinity();
}

// Reference: a scan of 4000 poses by the exact test.
TEST(SeparateWithin, soups_and_knots_come_free_no_later_than_a_scan_finds_and_touch_before) {
  std::mt19937_64 random(5);
  int compared = 0;
  for (const test::BodyPair& bodies : test::body_pairs(31)) {
    const Pair pair(bodies.a, bodies.b);
    const double size = bodies.a->mass.radius + bodies.b->mass.radius;
    for (int i = 0; i < 12; ++i) {
      const Pose X = test::random_pose(random, *bodies.a, *bodies.b, 0.7);
      if (!touch(pair, X)) continue;
      ++compared;
      const double rounding = rounding_guard(extent(*bodies.a), extent(*bodies.b), X.p);
      const Vec3 direction = test::random_rotation(random) * Vec3::UnitX();
      const Separation slid = along(pair, X, {direction});
      ASSERT_EQ(slid.status, Status::penetrating) << bodies.name;
      EXPECT_FALSE(touch(pair, slid.separated)) << bodies.name;
      const auto line = [&](double s) { return Pose{X.q, X.p + s * direction}; };
      EXPECT_LE(slid.depth, first_free(pair, line, 3 * size, 4000) + 1e-9 * size) << bodies.name;
      const double before = 1e-7 * size + 4 * rounding;  // a pose beyond the place is returned
      EXPECT_TRUE(touch(pair, line(slid.depth - before))) << bodies.name << " " << i;

      const Vec3 point = X * bodies.a->mass.com + test::random_in_ball(random, size);
      const Vec3 axis = test::random_rotation(random) * Vec3::UnitX();
      const auto turn = [&](double angle) {
        const Quat q(Eigen::AngleAxisd(angle, axis));
        return Pose{(q * X.q).normalized(), point + q * (X.p - point)};
      };
      const auto back = [&](double angle) { return turn(-angle); };
      const double pi = std::numbers::pi;
      const double there = first_free(pair, turn, pi, 4000),
                   or_back = first_free(pair, back, pi, 4000);
      const Separation turned = separate_about(pair, X, point, axis);
      if (turned.status == Status::failed) {
        EXPECT_EQ(std::min(there, or_back), std::numeric_limits<double>::infinity());
        continue;
      }
      EXPECT_FALSE(touch(pair, turned.separated)) << bodies.name;
      const Quat q = turned.separated.q * X.q.conjugate();
      const double angle = 2 * std::atan2(q.vec().norm(), std::abs(q.w()));
      EXPECT_LE(angle, std::min(there, or_back) + 1e-7) << bodies.name;
      EXPECT_TRUE(touch(pair, turn(angle - 1e-6)) && touch(pair, back(angle - 1e-6)))
          << bodies.name << " " << i;
    }
  }
  EXPECT_GT(compared, 30);
}

// Reference: the lower far corner of a rod that is hinged at its other end rises to the plane.
TEST(SeparateWithin, a_hinged_rod_turns_until_its_corner_is_in_the_plane) {
  const double length = 0.4, thick = 0.02, above = 0.03, down = 0.2;  // m, m, m, rad
  const Pair pair(test::body(test::scaled_and_moved(test::box({length, thick, 0.05}), 1,
                                                    Vec3(0.5 * length, 0, 0))),
                  test::body(test::scaled_and_moved(test::box({4, 1, 4}), 1, Vec3(0, -0.5, 0))));
  const Vec3 hinge(0, above, 0);
  const Pose X{Quat(Eigen::AngleAxisd(-down, Vec3::UnitZ())), hinge};
  const Separation found = separate_about(pair, X, hinge, 3 * Vec3::UnitZ());
  const double arm = std::hypot(length, 0.5 * thick), below = std::atan2(0.5 * thick, length);
  const double angle = down + below - std::asin(above / arm);  // of the turn back up
  ASSERT_EQ(found.status, Status::penetrating);
  const double sine = std::sin(0.5 * angle);
  // What it displaces the rod's points by: its centre on a chord, and about that.
  const double inertia = (length * length + thick * thick) / 12;
  EXPECT_NEAR(found.depth, 2 * sine * std::sqrt(0.25 * length * length + inertia), 1e-10);
  EXPECT_FALSE(touch(pair, found.separated));
}

TEST(SeparateWithin, no_turn_about_its_own_axis_frees_a_peg_in_a_solid) {
  const Pair pair = boxes({0.1, 0.1, 1}, {0.5, 0.5, 0.5});
  const Separation found = separate_about(pair, at(Vec3::Zero()), Vec3::Zero(), Vec3::UnitZ());
  EXPECT_EQ(found.status, Status::failed);
  EXPECT_STREQ(found.reason, "no turn about the axis sets the probe free");
}

/// No less than it is, and no more than by the clearance that a search may leave (1e-4 of it).
void expect_about(double found, double depth) {
  EXPECT_GE(found, (1 - 1e-9) * depth);
  EXPECT_LE(found, (1 + 1e-4) * depth);
}

TEST(SeparateWithin, a_grain_crosses_a_body_a_million_times_as_large) {
  const Pair pair = boxes({1e-6, 1e-6, 1e-6}, {1, 1, 1});
  EXPECT_NEAR(along(pair, at({-0.4, 0.1, 0.1}), {Vec3::UnitX()}).depth, 0.9 + 0.5e-6, 1e-12);
}

// Reference: the shorter of the two ways in the plane, though the third is shorter still.
TEST(SeparateWithin, boxes_on_a_plane_slide_out_the_shorter_way) {
  const Pair pair = boxes({0.2, 0.3, 0.1}, {0.5, 0.4, 0.7});
  const Pose X = at({0.13, -0.04, 0.38});
  for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0, 0, -7)}) {
    const Separation found = separate_in_plane(pair, X, {normal, false});
    ASSERT_EQ(found.status, Status::penetrating);
    expect_about(found.depth, 0.35 - 0.13);
    EXPECT_FALSE(touch(pair, found.separated));
    EXPECT_EQ(found.separated.p.z(), X.p.z());
    EXPECT_LT(found.residual, 1e-3);
    ASSERT_TRUE(found.lower_bound);
    EXPECT_LE(*found.lower_bound, 0.02 + 1e-9) << "that of all motions";
  }
}

// Reference: the faces of box and post pass each other; the table below is never met.
TEST(SeparateWithin, a_box_hardly_above_a_table_slides_out_of_a_post) {
  for (const double above : {1e-3, 1e-6, 1e-9, 1e-12}) {
    PolygonSoup fixed = test::box({0.06, 0.08, 0.5});
    PolygonSoup table = test::box({2, 2, 0.2});
    for (Vec3& x : table.points) x.z() -= 0.15 + above;
    const Pair pair(test::body(test::box({0.1, 0.1, 0.1})),
                    test::body(joined(std::move(fixed), table)));
    for (const bool turning : {false, true}) {
      const Pose X = at({0.07, 0.01, 0});
      const Separation found = separate_in_plane(pair, X, {Vec3::UnitZ(), turning});
      ASSERT_EQ(found.status, Status::penetrating) << above << ' ' << found.reason;
      EXPECT_NEAR(found.depth, 0.01, 2e-6) << above;
      EXPECT_EQ(found.separated.p.z(), 0) << above;
      EXPECT_FALSE(touch(pair, found.separated)) << above;
    }
  }
}

// Reference: the least over all turns of how far a rod's lowest corner is below the plane then, by
// a search of one dimension that knows nothing of meshes.
TEST(SeparateWithin, a_rod_on_a_plane_slides_and_turns_out_by_the_least_of_both) {
  const double length = 0.3, thick = 0.04;
  const Pair pair(test::body(test::box({length, thick, 0.05})),
                  test::body(test::scaled_and_moved(test::box({4, 2, 4}), 1, Vec3(0, -1, 0))));
  const double inertia = (length * length + thick * thick) / 12;
  for (const double tilt : {0.1, 0.35, -0.6}) {
    const double height = 0.03;
    const auto sigma = [&](double turn) {
      double lowest = 0;
      for (const double x : {-0.5 * length, 0.5 * length})
        for (const double y : {-0.5 * thick, 0.5 * thick})
          lowest = std::min(lowest, height + x * std::sin(tilt + turn) + y * std::cos(tilt + turn));
      return lowest * lowest + 4 * inertia * std::pow(std::sin(0.5 * turn), 2);
    };
    double least = sigma(0);
    for (int i = -200000; i <= 200000; ++i) least = std::min(least, sigma(i * 1e-5));
    const Pose X{Quat(Eigen::AngleAxisd(tilt, Vec3::UnitZ())), Vec3(0.1, height, 0.2)};
    const Separation found = separate_in_plane(pair, X, {Vec3::UnitZ(), true});
    ASSERT_EQ(found.status, Status::penetrating);
    expect_about(found.depth, std::sqrt(least));
    EXPECT_FALSE(touch(pair, found.separated));
    const Quat turned = found.separated.q * X.q.conjugate();
    EXPECT_LT(turned.vec().head<2>().norm(), 1e-12) << "about the normal alone";
    EXPECT_NEAR(found.separated.p.z(), 0.2, 1e-12);
    const Separation slid = separate_in_plane(pair, X, {Vec3::UnitZ(), false});
    expect_about(slid.depth, std::sqrt(sigma(0)));
  }
}

// Reference: the motions of one family are among those of the next.
TEST(SeparateWithin, the_more_motions_the_less_deep) {
  std::mt19937_64 random(8);
  const auto knot = test::body(test::torus_knot(2, 3, 0.1, 0.04, 0.03, 40, 8));
  const Pair pair(knot, knot);
  int compared = 0;
  for (int i = 0; i < 8; ++i) {
    const Pose X = test::random_pose(random, *knot, *knot, 0.5);
    if (!touch(pair, X)) continue;
    ++compared;
    const Vec3 normal = test::random_rotation(random) * Vec3::UnitX();
    const Vec3 across = normal.unitOrthogonal();
    const Separation line = along(pair, X, {across, -across});
    const Separation slide = separate_in_plane(pair, X, {normal, false});
    const Separation turn = separate_in_plane(pair, X, {normal, true});
    const Separation all = separate_static(pair, X, {});
    for (const Separation* found : {&line, &slide, &turn}) {
      ASSERT_EQ(found->status, Status::penetrating);
      EXPECT_FALSE(touch(pair, found->separated));
    }
    EXPECT_LE(slide.depth, 1.001 * line.depth);
    EXPECT_LE(turn.depth, 1.02 * slide.depth);
    EXPECT_LE(all.depth, 1.02 * turn.depth);
    EXPECT_LE(*turn.lower_bound, turn.depth);
  }
  EXPECT_GT(compared, 4);
}

TEST(SeparateWithin, a_free_pose_is_its_own_answer_and_the_same_call_gives_the_same_bits) {
  const Pair pair = boxes({0.2, 0.3, 0.1}, {0.5, 0.4, 0.7});
  EXPECT_EQ(along(pair, at({9, 0, 0}), {Vec3::UnitX()}).status, Status::separated);
  EXPECT_EQ(separate_about(pair, at({9, 0, 0}), Vec3::Zero(), Vec3::UnitX()).status,
            Status::separated);
  EXPECT_EQ(separate_in_plane(pair, at({9, 0, 0}), {}).status, Status::separated);
  const Pose X = at({0.13, -0.04, 0.21});
  EXPECT_EQ(separate_in_plane(pair, X, {}).depth, separate_in_plane(pair, X, {}).depth);
}

TEST(SeparateWithin, what_is_no_direction_is_refused_and_a_lost_pose_fails) {
  const Pair pair = boxes({0.2, 0.3, 0.1}, {0.5, 0.4, 0.7});
  const Pose X = at(Vec3::Zero());
  EXPECT_THROW(along(pair, X, {}), InputError);
  EXPECT_THROW(along(pair, X, {Vec3::UnitX(), Vec3::Zero()}), InputError);
  EXPECT_THROW(along(pair, X, {Vec3(nan, 0, 0)}), InputError);
  EXPECT_THROW(separate_about(pair, X, Vec3(0, nan, 0), Vec3::UnitX()), InputError);
  EXPECT_THROW(separate_about(pair, X, Vec3::Zero(), Vec3::Zero()), InputError);
  EXPECT_THROW(separate_in_plane(pair, X, {Vec3::Zero()}), InputError);
  EXPECT_THROW(separate_in_plane(pair, X, {}, {.starts = -5}), InputError);
  EXPECT_EQ(along(pair, at({nan, 0, 0}), {Vec3::UnitX()}).status, Status::failed);
  EXPECT_THROW(
      separate_along(pair, X, std::vector<Vec3>{Vec3::UnitX()}, [](double) { return false; }),
      Cancelled);
}

}  // namespace
}  // namespace sonde
