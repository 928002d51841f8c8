// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/principal_axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/base/elementary.hpp"

namespace sonde {
namespace {

/// The eigenvalues, ascending, of a matrix with entries of at most 1 and a trace of about 0.
Vec3 eigenvalues_of(const Mat3& m) {
  const double c0 = m(0, 0) * m(1, 1) * m(2, 2) + 2 * m(1, 0) * m(2, 0) * m(2, 1) -
                    m(0, 0) * m(2, 1) * m(2, 1) - m(1, 1) * m(2, 0) * m(2, 0) -
                    m(2, 2) * m(1, 0) * m(1, 0);
  const double c1 = m(0, 0) * m(1, 1) - m(1, 0) * m(1, 0) + m(0, 0) * m(2, 2) - m(2, 0) * m(2, 0) +
                    m(1, 1) * m(2, 2) - m(2, 1) * m(2, 1);
  const double c2 = m(0, 0) + m(1, 1) + m(2, 2);
  const double third = 1.0 / 3, mean = c2 * third;
  const double a = std::max((c2 * mean - c1) * third, 0.0);
  const double half_b = 0.5 * (c0 + mean * (2 * mean * mean - c1));
  const double q = std::max(a * a * a - half_b * half_b, 0.0);
  const double size = std::sqrt(a), angle = elementary::atan2(std::sqrt(q), half_b) * third;
  const double cosine = elementary::cos(angle), sine = std::sqrt(3.0) * elementary::sin(angle);
  return {mean - size * (cosine + sine), mean - size * (cosine - sine), mean + 2 * size * cosine};
}

/// For a matrix of rank 2: its null direction, and one of its columns, which is perpendicular to
/// it.
struct Kernel {
  Vec3 along, across;
};

Kernel kernel_of(const Mat3& m) {
  int largest = 0;
  m.diagonal().cwiseAbs().maxCoeff(&largest);
  const Vec3 across = m.col(largest);
  const Vec3 one = across.cross(m.col((largest + 1) % 3));
  const Vec3 other = across.cross(m.col((largest + 2) % 3));
  const double n0 = one.squaredNorm(), n1 = other.squaredNorm();
  return {n0 > n1 ? Vec3(one / std::sqrt(n0)) : Vec3(other / std::sqrt(n1)), across};
}

Mat3 shifted(Mat3 m, double by) {
  m.diagonal().array() -= by;
  return m;
}

}  // namespace

Mat3 principal_axes(const Mat3& symmetric) noexcept {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  Mat3 scaled = shifted(symmetric.selfadjointView<Eigen::Lower>(), symmetric.trace() / 3);
  const double scale = scaled.cwiseAbs().maxCoeff();
  if (scale > 0) scaled /= scale;
  const Vec3 values = eigenvalues_of(scaled);
  if (values[2] - values[0] <= epsilon) return Mat3::Identity();

  // First the eigenvector of the eigenvalue that is farthest from the others.
  double near = values[2] - values[1], far = values[1] - values[0];
  int first = 0, second = 2;
  if (near > far) {
    std::swap(first, second);
    std::swap(near, far);
  }
  Mat3 axes;
  const Kernel kernel = kernel_of(shifted(scaled, values[first]));
  axes.col(first) = kernel.along;
  if (near <= 2 * epsilon * far) {
    const Vec3& across = kernel.across;
    axes.col(second) = (across - kernel.along.dot(across) * across).normalized();
  } else {
    axes.col(second) = kernel_of(shifted(scaled, values[second])).along;
  }
  axes.col(1) = axes.col(2).cross(axes.col(0)).normalized();
  return axes;
}

}  // namespace sonde
