// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// Where a line goes through a triangle.
struct LineHit {
  double along;            ///< m, in the direction of the line
  std::uint32_t triangle;  ///< of the soup
  int sign;                ///< 1 where it leaves through the triangle's front, -1 where it enters
};

/// Parallel lines through a soup, as a square raster of count x count pixels, each with one line
/// somewhat off its middle, and where they go through triangles. Corners are rounded to 2^-20 of a
/// pixel across the lines, and then all is exact: on triangles that share their corners (by index)
/// and are closed, the signs along every line sum to zero, and no line slips through between two
/// of them.
class Lines {
 public:
  /// @param across_to Rows: two directions across the lines, then that of the lines; orthonormal.
  /// @param count Pixels along a side, at most 512.
  /// @param low, size The square's lower corner in the first two coordinates, and its side, m;
  /// size > 0.
  Lines(const Soup& soup, const Eigen::Matrix3d& across_to, int count, const Eigen::Vector2d& low,
        double size);
  /// Through all of a soup that has an extent.
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

/// Directions of lines in general position, square to each other: rows as Lines takes them, the
/// k-th of three with another of the rows last.
Eigen::Matrix3d line_frame(int k);

}  // namespace sonde
