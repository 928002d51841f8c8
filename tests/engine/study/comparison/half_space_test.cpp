// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/comparison/half_space.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

double lowest(const Body& body, const Pose& X_FM, const Plane& plane) {
  double out = std::numeric_limits<double>::infinity();
  for (const Vec3& x : body.soup.vertices) out = std::min(out, plane.height(X_FM * x));
  return out;
}

// The pose that is returned touches the plane, and its distance by the object norm is the depth: U
// = ½kσ, told by the wrench's own force and torque, is another way to the same number.
TEST(HalfSpace, the_separated_pose_touches_and_is_as_far_as_the_depth_says) {
  std::mt19937_64 random(5);
  const auto body = test::body(test::box({0.05, 0.1, 0.15}));
  for (int i = 0; i < 6; ++i) {
    const Plane plane{test::random_in_ball(random, 1).normalized(), 0.3};
    const Quat q = test::random_rotation(random);
    const double down = lowest(*body, {q, Vec3::Zero()}, plane);
    const Pose X{q, (-down - 0.02) * plane.normal};
    const HalfSpaceSeparation s = half_space_separation(*body, X, plane, 1, 20);
    EXPECT_NEAR(lowest(*body, s.separated, plane), 0, 1e-9);
    EXPECT_LE(s.depth, 0.02 * (1 + 1e-12)) << "straight up is one of the ways";
    const Quat turn = X.q.conjugate() * s.separated.q;
    const Vec3 v = body->mass.R_MP.transpose() * turn.vec();
    const double t = separation_motion(body->mass, X, s.separated).t.norm();
    EXPECT_NEAR(s.depth * s.depth, t * t + 4 * v.dot(body->mass.inertia.cwiseProduct(v)), 1e-12);
  }
}

// Reference: a ball is not turned by anything; its mesh is within 1 % of one.
TEST(HalfSpace, a_ball_goes_straight_up) {
  const auto ball = test::body(test::sphere(0.05, 24, 48));
  const HalfSpaceSeparation s =
      half_space_separation(*ball, {Quat::Identity(), Vec3(0, 0, 0.04)}, Plane{}, 1, 10);
  EXPECT_NEAR(s.depth, 0.01, 0.01 * 0.02);
}

TEST(HalfSpace, only_boxes_have_the_faces_of_a_box) {
  const auto box = test::body(test::box({1, 2, 3}));
  const auto faces = box_faces(*box);
  ASSERT_EQ(faces.size(), 6u);
  double sum = 0;
  for (const Plane& face : faces) sum += face.offset;
  EXPECT_NEAR(sum, 1 + 2 + 3, 1e-12);
  EXPECT_TRUE(box_faces(*test::body(test::tetrahedron(1))).empty());
  PolygonSoup sheared = test::box({1, 1, 1});
  for (Vec3& x : sheared.points) x.x() += 0.1 * x.z();
  EXPECT_TRUE(box_faces(*test::body(sheared)).empty());
}

TEST(HalfSpace, a_large_box_is_one_away_from_its_edges) {
  const auto probe = test::body(test::box({0.02, 0.02, 0.02}));
  const auto faces = box_faces(*test::body(test::box({1, 1, 1})));
  const auto at = [&](double x, double z) {
    return half_space_below(*probe, {Quat::Identity(), Vec3(x, 0, z)}, faces);
  };
  ASSERT_TRUE(at(0, 0.505));
  EXPECT_GT(at(0, 0.505)->normal.z(), 0.99);
  EXPECT_TRUE(at(0.497, 0)) << "any face will do";
  EXPECT_FALSE(at(0, 0.52)) << "free";
  EXPECT_FALSE(at(0.49, 0.505)) << "at an edge";
  EXPECT_FALSE(at(0, 0)) << "deep inside";
  EXPECT_FALSE(half_space_below(*probe, {}, {}));
}

}  // namespace
}  // namespace sonde
