// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// Two axes of a box in single precision; the third is their cross product.
using SmallAxes = std::array<std::array<float, 3>, 2>;

/// The given axes (columns), orthogonalised; the frame's axes if that fails.
SmallAxes small_axes(const Mat3& axes);
/// The axes in double precision, as columns: orthonormal to 1e-6.
Mat3 axes_of(const SmallAxes& small);

/// Mean and covariance of the area of triangles, summed incrementally.
struct AreaMoments {
  double area = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  void add(const Vec3& a, const Vec3& b, const Vec3& c);
  void add(const AreaMoments& other);
  /// Principal axes, as columns; the identity if there is no area.
  Mat3 axes() const;
};

/// Axes of a triangle: along its longest edge and its normal.
Mat3 triangle_axes(const Vec3& a, const Vec3& b, const Vec3& c);

/// The range of points along three axes.
struct Extent {
  explicit Extent(const Mat3& axes) : to_axes(axes.transpose()) {}  // columns: the axes
  void add(const Vec3& x) {
    const Vec3 y = to_axes * x;
    low = low.cwiseMin(y);
    high = high.cwiseMax(y);
  }
  Mat3 to_axes;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
};

/// A single-precision box that contains the extent, enlarged for axes that are not exactly
/// orthogonal and by `slack` (m) for the rounding of the points.
struct SmallBox {
  std::array<float, 3> center;
  std::array<float, 3> half;
};
SmallBox small_box(const Extent& extent, double slack);

}  // namespace sonde
