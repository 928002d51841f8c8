// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/queries/body_queries.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/body/body.hpp"
#include "engine/proximity/queries/ray_hit.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

constexpr double no_point = std::numeric_limits<double>::quiet_NaN();

// Reference: the box's own formula, |xᵢ| < halfᵢ.
TEST(BodyQueries, inside_of_a_box_is_where_all_coordinates_are_less_than_half_its_sides) {
  std::mt19937_64 random(1);
  const Vec3 size(0.3, 0.5, 0.2);
  const auto box = test::body(test::box(size));
  for (int i = 0; i < 2000; ++i) {
    const Vec3 x = test::random_in_ball(random, 0.4);
    EXPECT_EQ(inside(*box, x), (x.cwiseAbs().array() < 0.5 * size.array()).all()) << x.transpose();
  }
}

// Reference: winding numbers by solid angles over all triangles.
TEST(BodyQueries, inside_of_a_knot_is_where_its_winding_number_is_not_0) {
  std::mt19937_64 random(2);
  const auto knot = test::body(test::torus_knot(2, 3, 0.1, 0.04, 0.03, 60, 8));
  int within = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 x = test::random_in_ball(random, 0.17);
    const bool expected = std::abs(test::solid_angle_winding(*knot, x)) >= 0.5;
    EXPECT_EQ(inside(*knot, x), expected) << x.transpose();
    within += expected;
  }
  EXPECT_GT(within, 50);
}

TEST(BodyQueries, a_surface_has_no_inside) {
  const auto box = test::body(test::box({1, 1, 1}), Model::surface);
  EXPECT_FALSE(inside(*box, Vec3::Zero()));
}

// Reference: the distance of a point from a box, and the box's own normals.
TEST(BodyQueries, the_nearest_point_of_a_box_is_the_point_cut_to_its_sides) {
  std::mt19937_64 random(3);
  const Vec3 half(0.15, 0.25, 0.1);
  const auto box = test::body(test::box(2 * half));
  for (int i = 0; i < 1000; ++i) {
    const Vec3 x = test::random_in_ball(random, 1);
    if (inside(*box, x)) continue;
    const Vec3 expected = x.cwiseMax(-half).cwiseMin(half);
    const SurfacePoint found = nearest_point(*box, x);
    EXPECT_LT((found.point - expected).norm(), 1e-14);
    EXPECT_NEAR(found.distance, (x - expected).norm(), 1e-14);
    EXPECT_NEAR(found.normal.norm(), 1, 1e-14);
    EXPECT_GE(found.normal.dot(x - expected), -1e-14) << "outwards";
  }
}

// Reference: the same point of a triangle by brute force over all triangles (tests of
// point_distance go further).
TEST(BodyQueries, the_nearest_point_of_a_soup_is_that_of_all_its_triangles) {
  std::mt19937_64 random(4);
  const auto soup = test::body(test::random_soup(random, 80, 0.3));
  for (int i = 0; i < 200; ++i) {
    const Vec3 x = test::random_in_ball(random, 0.5);
    double least = std::numeric_limits<double>::infinity();
    for (const Corners& t : test::placed_triangles(*soup, Transform()))
      least = std::min(least, test::triangle_distance_bounds({x, x, x}, t).upper);
    EXPECT_NEAR(nearest_point(*soup, x).distance, least, 1e-14);
  }
}

// Reference: the slabs of a box.
TEST(BodyQueries, a_ray_meets_a_box_where_it_enters_its_slabs) {
  std::mt19937_64 random(5);
  const Vec3 half(0.15, 0.25, 0.1);
  const auto box = test::body(test::box(2 * half));
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from = test::random_in_ball(random, 0.6);
    const Vec3 direction = test::random_in_ball(random, 3);
    const Vec3 unit = direction.normalized();
    const Vec3 a = (-half - from).cwiseQuotient(unit), b = (half - from).cwiseQuotient(unit);
    const double enter = a.cwiseMin(b).maxCoeff(), leave = a.cwiseMax(b).minCoeff();
    const auto found = ray(*box, from, direction);
    if (std::abs(enter - leave) < 1e-9) continue;  // along an edge, either
    const bool expected = enter < leave && leave >= 0;
    ASSERT_EQ(found.has_value(), expected) << i;
    if (!expected) continue;
    ++hits;
    EXPECT_NEAR(found->distance, enter >= 0 ? enter : leave, 1e-12);
    EXPECT_LT((found->point - from - found->distance * unit).norm(), 1e-15);
    EXPECT_EQ(found->normal.dot(unit) < 0, enter >= 0) << "into it, or out";
  }
  EXPECT_GT(hits, 150);
}

// Reference: every triangle, one by one (ray_hit).
TEST(BodyQueries, a_ray_through_a_tree_meets_what_one_past_all_triangles_meets) {
  std::mt19937_64 random(6);
  const auto soup = test::body(test::random_soup(random, 400, 0.3));
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 from = test::random_in_ball(random, 0.6), to = test::random_in_ball(random, 0.6);
    const Vec3 unit = (to - from).normalized();
    const auto all = ray_hit(surface(*soup), from, unit);
    const auto found = ray(*soup, from, unit);
    ASSERT_EQ(found.has_value(), all.has_value());
    if (!all) continue;
    EXPECT_NEAR(found->distance, all->distance, 1e-14);
    ++hits;
  }
  EXPECT_GT(hits, 100);
}

// Reference: a closed surface has no way out. Rays at corners and along edges are the hard ones.
TEST(BodyQueries, no_ray_slips_out_between_triangles) {
  std::mt19937_64 random(7);
  for (const PolygonSoup& shape :
       {test::sphere(0.1, 9, 13), test::torus(0.1, 0.04, 12, 7), test::box({0.1, 0.2, 0.3})}) {
    const auto body = test::body(shape);
    const Soup& soup = surface(*body);
    const Vec3 from = soup.vertices.front() +
                      1e-3 * (Vec3(0.01, 0.02, 0) - soup.vertices.front());  // next to a corner
    const Vec3 start = inside(*body, from) ? from : body->mass.com;
    if (!inside(*body, start)) continue;
    for (const Triangle& t : soup.triangles)
      for (int i = 0; i < 3; ++i) {
        const double at = test::uniform(random, 0, 1);
        const Vec3 &a = soup.vertices[t[static_cast<std::size_t>(i)]],
                   &b = soup.vertices[t[static_cast<std::size_t>((i + 1) % 3)]];
        EXPECT_TRUE(ray(*body, start, a - start));
        EXPECT_TRUE(ray(*body, start, a + at * (b - a) - start));
      }
  }
}

TEST(BodyQueries, what_is_no_point_is_refused_with_the_reason) {
  const auto box = test::body(test::box({1, 1, 1}));
  EXPECT_THROW(inside(*box, {no_point, 0, 0}), InputError);
  EXPECT_THROW(nearest_point(*box, {0, no_point, 0}), InputError);
  EXPECT_THROW(nearest_point(*box, {0, 1e31, 0}), InputError);
  EXPECT_THROW(ray(*box, {0, 0, no_point}, {1, 0, 0}), InputError);
  EXPECT_THROW(ray(*box, {0, 0, 0}, {0, 0, 0}), InputError);
  EXPECT_FALSE(inside(*box, {1e300, 0, 0}));
  EXPECT_NEAR(nearest_point(*box, {1e20, 0, 0}).distance, 1e20, 1e6);
  EXPECT_TRUE(ray(*box, {0, 0, 0}, {1e-200, 0, 0})) << "however short the direction";
}

TEST(BodyQueries, nothing_is_allocated) {
  const auto knot = test::body(test::torus_knot(2, 3, 0.1, 0.04, 0.03, 60, 8));
  test::AllocationCounter counter;
  (void)inside(*knot, {0.1, 0, 0});
  (void)nearest_point(*knot, {0.2, 0, 0});
  (void)ray(*knot, {0.2, 0, 0}, {-1, 0.1, 0});
  counter.stop();
  EXPECT_EQ(counter.allocations() + counter.frees(), 0u);
}

}  // namespace
}  // namespace sonde
