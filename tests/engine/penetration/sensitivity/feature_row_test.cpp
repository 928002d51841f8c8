// SPDX-License-Identifier: GPL-3.0-or-later
// References: the gap by its definition, as the distance of a point from a plane or of two lines,
// and central differences of it and of its derivatives.
#include "engine/penetration/sensitivity/feature_row.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/penetration/sensitivity/exact_optimum.hpp"
#include "tests/support/differenced_wrench.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using Kind = FeatureRow::Kind;

Vec3 random_direction(std::mt19937_64& random) {
  return test::random_rotation(random) * Vec3::UnitZ();
}

/// Features of a size of about one, a small gap apart.
FeatureRow random_row(std::mt19937_64& random, Kind kind) {
  FeatureRow row{kind,
                 test::random_in_ball(random, 1),
                 random_direction(random),
                 Vec3::Zero(),
                 random_direction(random),
                 test::uniform(random, 0, 1) < 0.5 ? 1.0 : -1.0};
  return row;
}

double gap_of(const FeatureRow& row, const Transform& X) {
  const Vec3 between = X * row.a - row.b;
  switch (row.kind) {
    case Kind::vertex_on_face:
      return row.along_b.dot(between);
    case Kind::face_on_vertex:
      return (X.R * row.along_a).dot(between);
    case Kind::edge_on_edge:
      break;
  }
  return row.sign * (X.R * row.along_a).cross(row.along_b).normalized().dot(between);
}

Vec6 slope(const FeatureRowAt& at) {
  Vec6 out;
  out << at.normal, at.arm.cross(at.normal);
  return out;
}

TEST(FeatureRow, slopes_and_curvatures_are_those_of_the_gap) {
  std::mt19937_64 random(7);
  MassProperties mass;
  mass.com = Vec3(0.1, -0.2, 0.3);
  for (int i = 0; i < 300; ++i) {
    const auto kind = static_cast<Kind>(i % 3);
    FeatureRow row = random_row(random, kind);
    const Pose X{test::random_rotation(random), test::random_in_ball(random, 1)};
    row.b = Transform(X) * row.a + 0.3 * random_direction(random);
    const FeatureRowAt at = row_at(row, Transform(X), mass.com);
    if (kind == Kind::edge_on_edge && (X.q * row.along_a).cross(row.along_b).norm() < 0.2)
      continue;  // Nearly parallel lines turn too fast for differences.
    const FeatureRowChange change = row_change(row, at, Transform(X));
    ASSERT_NEAR(at.gap, gap_of(row, Transform(X)), 1e-12);
    const double h = 1e-5;
    for (Eigen::Index k = 0; k < 6; ++k) {
      const Pose ahead = test::moved_by(mass, X, h * Vec6::Unit(k)),
                 behind = test::moved_by(mass, X, -h * Vec6::Unit(k));
      const double gap = (gap_of(row, Transform(ahead)) - gap_of(row, Transform(behind))) / (2 * h);
      EXPECT_NEAR(slope(at)[k], gap, 1e-7) << i << ' ' << k;
      const FeatureRowAt next = row_at(row, Transform(ahead), mass.com),
                         last = row_at(row, Transform(behind), mass.com);
      const Vec3 turns = (next.normal - last.normal) / (2 * h),
                 arm = (next.arm - last.arm) / (2 * h);
      EXPECT_LT((change.normal.col(k) - turns).norm(), 1e-6) << i << ' ' << k;
      // The arm counts but for what is along the normal.
      EXPECT_LT((change.arm.col(k) - arm).cross(at.normal).norm(), 1e-5) << i << ' ' << k;
    }
  }
}

TEST(HalfSigma, wrench_and_its_change_are_derivatives_of_sigma) {
  std::mt19937_64 random(8);
  MassProperties mass;
  mass.com = Vec3(0.1, -0.2, 0.3);
  mass.inertia = Vec3(0.1, 0.3, 0.35);
  mass.R_MP = test::random_rotation(random).toRotationMatrix();
  const double h = 1e-5;
  for (int i = 0; i < 100; ++i) {
    const Pose O{test::random_rotation(random), test::random_in_ball(random, 1)},
        Q{test::random_rotation(random), test::random_in_ball(random, 1)};
    const HalfSigma at = half_sigma(mass, O, Q);
    const Chart chart(mass, O);
    EXPECT_NEAR(at.sigma, chart.coordinates(Q).squaredNorm(), 1e-12);
    for (Eigen::Index k = 0; k < 6; ++k) {
      const auto beside = [&](bool device, double by) {
        const Vec6 motion = by * Vec6::Unit(k);
        return device ? half_sigma(mass, test::moved_by(mass, O, motion), Q)
                      : half_sigma(mass, O, test::moved_by(mass, Q, motion));
      };
      const HalfSigma ahead = beside(false, h), behind = beside(false, -h);
      // At a half turn the other one becomes the shorter: differences across that are of no use.
      EXPECT_NEAR(at.wrench[k], (ahead.sigma - behind.sigma) / (4 * h), 1e-8);
      EXPECT_NEAR(at.wrench[k], -(beside(true, h).sigma - beside(true, -h).sigma) / (4 * h), 1e-8);
      EXPECT_LT((at.by_motion.col(k) - (ahead.wrench - behind.wrench) / (2 * h)).norm(), 1e-8);
    }
  }
}

}  // namespace
}  // namespace sonde
