// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sketch/distance_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/point_distance.hpp"
#include "tests/support/pairs.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::vector<std::pair<const char*, std::shared_ptr<const Body>>> solids() {
  return {{"box", test::body(test::box({0.1, 0.2, 0.15}))},
          {"sphere", test::body(test::sphere(0.1, 16, 24))},
          {"torus", test::body(test::torus(0.08, 0.03, 24, 16))},
          {"far", test::body(test::scaled_and_moved(test::torus(0.08, 0.03, 24, 16), 1,
                                                    Vec3(50, -20, 70)))}};
}

Vec3 in_mesh_frame(const Body& body, const Vec3& x) { return body.mass.R_MP * x + body.mass.com; }
double signed_distance(const Body& body, const Vec3& x) {
  const Vec3 in_mesh = in_mesh_frame(body, x);
  return (winds_around(body, in_mesh) ? -1 : 1) * point_distance(body, in_mesh);
}

// Reference: the distance of the point from the triangles, and the winding number. Distance and
// planes change by no more than the way to the node does, which bounds the error by √3 spacings
// where the planes do not agree at all (in the middle of a tube); on the whole it is far less.
TEST(DistanceField, is_about_the_distance) {
  std::mt19937_64 random(1);
  for (const auto& [name, body] : solids()) {
    const DistanceField field(*body);
    double sum = 0;
    int points = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 x = test::random_in_ball(random, 1.2 * body->mass.radius);
      if (field.at_least(quad(x)) > 0) continue;
      const auto got = static_cast<double>(field.at(quad(x))[3]);
      const double error = std::abs(got - signed_distance(*body, x));
      EXPECT_LT(error, 1.7321 * field.spacing()) << name;
      sum += error;
      ++points;
    }
    EXPECT_GT(points, 200) << name;
    EXPECT_LT(sum / points, 0.1 * field.spacing()) << name;
  }
}

// Reference: the faces of the box, beside which the field is a plane.
TEST(DistanceField, is_exact_beside_a_flat_face) {
  const auto box = test::body(test::box({0.1, 0.2, 0.3}));
  const DistanceField field(*box);
  std::mt19937_64 random(2);
  int looked = 0;
  for (int i = 0; i < 500; ++i) {
    // The principal axes of a box are those of its sides, the longest first.
    const Vec3 half(0.15, 0.1, 0.05);
    const Vec3 x(test::uniform(random, -0.08, 0.08), test::uniform(random, -0.04, 0.04),
                 half[2] + test::uniform(random, -0.01, 0.015));
    const Quad got = field.at(quad(x));
    EXPECT_NEAR(static_cast<double>(got[3]), x[2] - half[2], 1e-6);
    EXPECT_LT((vec3(got) - Vec3::UnitZ()).norm(), 1e-5);
    ++looked;
  }
  EXPECT_EQ(looked, 500);
}

// Reference: the distance of the point from the triangles.
TEST(DistanceField, far_points_are_no_nearer_than_it_says) {
  std::mt19937_64 random(3);
  int outside = 0;
  for (const auto& [name, body] : solids()) {
    const DistanceField field(*body);
    for (int i = 0; i < 500; ++i) {
      const Vec3 x = test::random_in_ball(random, 4 * body->mass.radius);
      const auto least = static_cast<double>(field.at_least(quad(x)));
      if (least <= 0) continue;
      const double distance = point_distance(*body, in_mesh_frame(*body, x));
      EXPECT_LE(least, distance) << name;
      EXPECT_NEAR(static_cast<double>(field.at(quad(x))[3]), distance, 0.3 * distance) << name;
      ++outside;
    }
  }
  EXPECT_GT(outside, 500);
}

}  // namespace
}  // namespace sonde
