// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// The point where a line passes through a triangle.
struct LineHit {
  double along;            ///< m, in the direction of the line
  std::uint32_t triangle;  ///< of the soup
  int sign;                ///< 1 if it leaves through the triangle's front, -1 if it enters there
};

/// Parallel lines through a soup, one for each pixel of a square raster of count x count pixels,
/// slightly off the pixel's middle, and their hits on triangles. Corners are rounded to 2^-20 of a
/// pixel across the lines; after that everything is exact: for closed triangles that share their
/// corners (by index), the signs along every line sum to zero, and no line slips through between
/// two of them.
class Lines {
 public:
  /// @param across_to Rows: two directions across the lines, then that of the lines; orthonormal.
  /// @param count Pixels along a side, at most 512.
  /// @param low, size The square's lower corner in the first two coordinates, and its side, m;
  /// size > 0.
  Lines(const Soup& soup, const Eigen::Matrix3d& across_to, int count, const Eigen::Vector2d& low,
        double size);
  /// Lines through all of a soup that has an extent.
  Lines(const Soup& soup, const Eigen::Matrix3d& across_to, int count);

  std::size_t size() const { return start_.size() - 1; }
  /// The hits of line i, ascending along it (ties by triangle).
  std::span<const LineHit> operator[](std::size_t i) const {
    return {hits_.data() + start_[i], start_[i + 1] - start_[i]};
  }
  double pixel() const { return pixel_; }  ///< m, the side of a pixel
  /// The point of line i at `along`, in the soup's frame.
  Vec3 point(std::size_t i, double along) const;

 private:
  void cast(const Soup& soup);

  Eigen::Matrix3d across_to_;
  int count_;
  Eigen::Vector2d low_;
  double pixel_;
  std::vector<std::size_t> start_;
  std::vector<LineHit> hits_;
};

/// Orthogonal directions of lines in general position: rows as Lines takes them; each of the three
/// k has another row last.
Eigen::Matrix3d line_frame(int k);

}  // namespace sonde
