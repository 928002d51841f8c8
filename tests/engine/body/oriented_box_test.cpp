// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/oriented_box.hpp"

#include <gtest/gtest.h>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

// Reference: what orthonormal means.
TEST(OrientedBox, axes_are_square_to_each_other_whatever_comes_in) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    Mat3 axes = test::random_rotation(random).toRotationMatrix();
    if (i % 3 == 1) axes.col(1) += 0.3 * axes.col(0);
    if (i % 3 == 2) axes *= 1e-20;
    if (i % 50 == 0) axes.col(1) = axes.col(0);
    if (i % 50 == 1) axes.setConstant(std::numeric_limits<double>::quiet_NaN());
    const Mat3 made = axes_of(small_axes(axes));
    EXPECT_LT((made.transpose() * made - Mat3::Identity()).cwiseAbs().maxCoeff(), 0x1p-21) << i;
  }
}

TEST(OrientedBox, a_needle_and_a_point_have_axes) {
  for (const double width : {1.0, 1e-8, 1e-16, 0.0}) {
    const Mat3 axes = triangle_axes({0, 0, 0}, {1, 2, 3}, {width, 2, 3});
    EXPECT_TRUE(axes.allFinite()) << width;
  }
  EXPECT_TRUE(
      axes_of(small_axes(triangle_axes(Vec3::Ones(), Vec3::Ones(), Vec3::Ones()))).allFinite());
}

// Reference: the second moment of a triangle from its subdivision into four, which it must equal.
TEST(OrientedBox, moments_add_up) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100; ++i) {
    const Mat3 t = 5 * Mat3::Random();
    const Vec3 a = t.col(0), b = t.col(1), c = t.col(2);
    const Vec3 ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
    AreaMoments whole, parts, half;
    whole.add(a, b, c);
    parts.add(a, ab, ca);
    parts.add(ab, b, bc);
    half.add(ca, bc, c);
    half.add(ab, bc, ca);
    parts.add(half);
    EXPECT_NEAR(parts.area, whole.area, 1e-12 * whole.area);
    EXPECT_LT((parts.first - whole.first).norm(), 1e-12 * (1 + whole.first.norm()));
    EXPECT_LT((parts.second - whole.second).norm(), 1e-12 * (1 + whole.second.norm()));
  }
}

// A flat piece is thin along the axis of least moment.
TEST(OrientedBox, axes_follow_a_plane) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100; ++i) {
    const Mat3 R = test::random_rotation(random).toRotationMatrix();
    AreaMoments moments;
    moments.add(R * Vec3(0, 0, 0), R * Vec3(2, 0, 0), R * Vec3(0, 1, 0));
    moments.add(R * Vec3(2, 0, 0), R * Vec3(2, 1, 0), R * Vec3(0, 1, 0));
    Extent extent(moments.axes());
    for (const Vec3& x : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)})
      extent.add(R * x);
    const SmallBox box = small_box(extent, 0);
    EXPECT_LT(std::min({box.half[0], box.half[1], box.half[2]}), 1e-5f);
  }
}

}  // namespace
}  // namespace sonde
