// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/snap.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/shapes.hpp"

namespace sonde::ui {
namespace {

Vec3 direction(std::mt19937_64& random) {
  return sonde::test::random_rotation(random) * Vec3::UnitX();
}

/// Where a feature of the probe is once that has gone from one pose to another.
Feature carried(const Feature& feature, const Pose& from, const Pose& to) {
  const Pose way = to * inverse(from);
  return {way * feature.at, way.q * feature.along};
}

struct Case {
  Pose X;
  Feature own, onto;
};
Case random_case(std::mt19937_64& random) {
  return {{sonde::test::random_rotation(random), sonde::test::random_in_ball(random, 1)},
          {sonde::test::random_in_ball(random, 1), direction(random)},
          {sonde::test::random_in_ball(random, 1), direction(random)}};
}

TEST(Snap, a_face_lies_on_the_other_and_looks_against_it) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 50; ++i) {
    const Case c = random_case(random);
    const Pose X = snapped(c.X, SnapKind::face, c.own, c.onto);
    const Feature now = carried(c.own, c.X, X);
    EXPECT_LT((now.along + c.onto.along).norm(), 1e-12);
    EXPECT_NEAR((now.at - c.onto.at).dot(c.onto.along), 0, 1e-12);
    EXPECT_LT((now.at - c.own.at).cross(c.onto.along).norm(), 1e-12) << "no slide";
  }
}

TEST(Snap, a_line_lies_on_the_other_whichever_way_is_nearer) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50; ++i)
    for (const SnapKind kind : {SnapKind::edge, SnapKind::axis}) {
      const Case c = random_case(random);
      const Pose X = snapped(c.X, kind, c.own, c.onto);
      const Feature now = carried(c.own, c.X, X);
      EXPECT_LT(now.along.cross(c.onto.along).norm(), 1e-12);
      EXPECT_GE(now.along.dot(c.own.along), -1e-12) << "by a right angle at most";
      EXPECT_LT((now.at - c.onto.at).cross(c.onto.along).norm(), 1e-12);
      EXPECT_NEAR((now.at - c.own.at).dot(c.onto.along), 0, 1e-12) << "no slide along it";
    }
}

// Faces that look the same way: half a turn, whose axis must not be the normals' last digits.
TEST(Snap, a_face_that_looks_the_same_way_is_turned_over_about_an_axis_of_the_fixed_body) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 50; ++i) {
    Case c = random_case(random);
    c.onto.along = Vec3::UnitZ();
    Vec3 noise = 1e-7 * direction(random);
    if (i == 0) noise.setZero();
    c.own.along = (c.onto.along + noise).normalized();
    const Pose X = snapped(c.X, SnapKind::face, c.own, c.onto);
    EXPECT_LT((carried(c.own, c.X, X).along + c.onto.along).norm(), 1e-12);
    const Quat turn = X.q * c.X.q.conjugate();
    EXPECT_LT(turn.angularDistance(Quat(0, 1, 0, 0)), 1e-6) << "half a turn about x";
  }
}

TEST(Snap, what_lies_there_stays) {
  std::mt19937_64 random(3);
  const Case c = random_case(random);
  const Pose X = snapped(c.X, SnapKind::axis, c.own, c.onto);
  const Pose again = snapped(X, SnapKind::axis, carried(c.own, c.X, X), c.onto);
  EXPECT_LT((again.p - X.p).norm(), 1e-12);
  EXPECT_LT(again.q.angularDistance(X.q), 1e-7);
}

}  // namespace
}  // namespace sonde::ui
