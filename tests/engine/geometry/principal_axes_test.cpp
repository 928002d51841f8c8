// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is the definition: a matrix made of known axes and values has them; and Eigen's
// solver by iteration.
#include "engine/geometry/principal_axes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "engine/geometry/random.hpp"

namespace sonde {
namespace {

/// A·axes - axes·D, where D is what is left of the diagonal, over the largest entry of A.
double residual(const Mat3& A, const Mat3& axes) {
  const Vec3 values = (axes.transpose() * A * axes).diagonal();
  return (A * axes - axes * values.asDiagonal()).norm() / A.norm();
}

TEST(PrincipalAxes, are_eigenvectors_by_rising_eigenvalues) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Mat3 R = random.rotation().toRotationMatrix();
    const double scale = std::ldexp(1.0, static_cast<int>(random.uniform(-300, 300)));
    const Vec3 values(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const Mat3 A = scale * (R * values.asDiagonal() * R.transpose());
    const Mat3 axes = principal_axes(A);
    EXPECT_LT((axes.transpose() * axes - Mat3::Identity()).norm(), 1e-6);
    EXPECT_LT(residual(A, axes), 1e-6);
    const Vec3 got = (axes.transpose() * A * axes).diagonal() / scale;
    const Vec3 want =
        Eigen::SelfAdjointEigenSolver<Mat3>(A / scale, Eigen::EigenvaluesOnly).eigenvalues();
    EXPECT_LT((got - want).norm(), 1e-9);
  }
}

TEST(PrincipalAxes, of_two_equal_values_are_any_that_fit) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Mat3 R = random.rotation().toRotationMatrix();
    for (const Vec3& values : {Vec3(1, 1, 3), Vec3(1, 3, 3), Vec3(0, 0, 1), Vec3(0, 1, 1)}) {
      const Mat3 A = R * values.asDiagonal() * R.transpose();
      EXPECT_LT(residual(A, principal_axes(A)), 1e-6);
    }
  }
}

TEST(PrincipalAxes, of_a_sphere_are_the_frame_s) {
  EXPECT_EQ(principal_axes(Mat3::Identity()), Mat3::Identity());
  EXPECT_EQ(principal_axes(Mat3::Zero()), Mat3::Identity());
}

}  // namespace
}  // namespace sonde
