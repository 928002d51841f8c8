// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/oriented_box.hpp"

#include <cmath>

#include "engine/geometry/principal_axes.hpp"
#include "engine/geometry/to_float.hpp"

namespace sonde {
namespace {

float rounded_up(double x) {
  float f = to_float(x);
  while (!(x <= static_cast<double>(f)))
    f = std::nextafter(f, std::numeric_limits<float>::infinity());
  return f;
}

}  // namespace

SmallAxes small_axes(const Mat3& axes) {
  // Orthogonalised again: for a tiny triangle, the axes come from denormal squares.
  Vec3 along[2] = {axes.col(0).normalized(), axes.col(1)};
  for (int twice = 0; twice < 2; ++twice)
    along[1] = (along[1] - along[1].dot(along[0]) * along[0]).normalized();
  if (!(std::abs(along[0].squaredNorm() - 1) < 1e-9 &&
        std::abs(along[1].squaredNorm() - 1) < 1e-9 && std::abs(along[0].dot(along[1])) < 1e-9)) {
    along[0] = Vec3::UnitX();
    along[1] = Vec3::UnitY();
  }
  SmallAxes small;
  for (std::size_t k = 0; k < 2; ++k)
    for (int i = 0; i < 3; ++i) small[k][static_cast<std::size_t>(i)] = to_float(along[k][i]);
  return small;
}

Mat3 axes_of(const SmallAxes& small) {
  Mat3 axes;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 3; ++i)
      axes(i, k) =
          static_cast<double>(small[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)]);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

void AreaMoments::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double twice = (b - a).cross(c - a).norm();
  const Vec3 sum = a + b + c;
  area += twice;
  first += twice / 3 * sum;
  second += twice / 12 *
            (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
}

void AreaMoments::add(const AreaMoments& other) {
  area += other.area;
  first += other.first;
  second += other.second;
}

Mat3 AreaMoments::axes() const {
  if (!(area > 0)) return Mat3::Identity();
  const Vec3 mean = first / area;
  const Mat3 covariance = second / area - mean * mean.transpose();
  Mat3 axes = principal_axes(covariance);
  if (!axes.allFinite()) return Mat3::Identity();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  return axes;
}

Mat3 triangle_axes(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 edges[3] = {b - a, c - b, a - c};
  int longest = 0;
  for (int i = 1; i < 3; ++i)
    if (edges[i].squaredNorm() > edges[longest].squaredNorm()) longest = i;
  const Vec3 along = edges[longest].normalized();
  // The component of the other edge across the longest spans the plane with it even in a needle.
  Vec3 across = edges[(longest + 1) % 3];
  for (int twice = 0; twice < 2; ++twice) across -= across.dot(along) * along;
  if (!(across.norm() > 0)) across = along.unitOrthogonal();
  Mat3 axes;
  axes.col(0) = along;
  axes.col(1) = across.normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes.allFinite() ? axes : Mat3::Identity();
}

SmallBox small_box(const Extent& extent, double slack) {
  const Vec3 middle = extent.to_axes.transpose() * (extent.low + (extent.high - extent.low) / 2);
  SmallBox box;
  Vec3 center;
  for (int i = 0; i < 3; ++i) {
    box.center[static_cast<std::size_t>(i)] = to_float(middle[i]);
    center[i] = static_cast<double>(box.center[static_cast<std::size_t>(i)]);
  }
  const Vec3 at = extent.to_axes * center;
  const Vec3 half = (extent.high - at).cwiseMax(at - extent.low);
  // The corners of the box are at Σ ±hᵢ aᵢ only if the axes aᵢ are orthonormal; they are to 2⁻²².
  const double crooked = 0x1p-20 * half.sum();
  for (int i = 0; i < 3; ++i)
    box.half[static_cast<std::size_t>(i)] = rounded_up(half[i] + crooked + slack);
  return box;
}

}  // namespace sonde
