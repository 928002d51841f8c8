// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/base/progress.hpp"
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
/// two of them. It refers to the soup, and must not outlive it.
class Lines {
 public:
  /// Receives a line's number and its hits, at least one; returns whether to go on.
  using Use = std::function<bool(std::size_t, std::span<const LineHit>)>;
  /// @param across_to Rows: two directions across the lines, then that of the lines; orthonormal.
  /// @param count Pixels along a side, at most 512.
  /// @param low, size The square's lower corner in the first two coordinates, and its side, m;
  /// size > 0.
  Lines(const Soup& soup, const Eigen::Matrix3d& across_to, int count, const Eigen::Vector2d& low,
        double size);
  /// Lines through all of a soup that has an extent.
  Lines(const Soup& soup, const Eigen::Matrix3d& across_to, int count);

  /// The lines that hit anything, in turn, each with its hits ascending along it (ties by
  /// triangle). Returns whether all were used. Throws Cancelled.
  bool each(const Use& use, const Progress& progress = {}) const;
  /// The same with the hits of a line in no order, which takes less time.
  bool each_unordered(const Use& use, const Progress& progress = {}) const;
  std::size_t size() const {
    return static_cast<std::size_t>(count_) * static_cast<std::size_t>(count_);
  }
  double pixel() const { return pixel_; }  ///< m, the side of a pixel
  /// The point of line i at `along`, in the soup's frame.
  Vec3 point(std::size_t i, double along) const;

 private:
  using Corner = std::array<std::int64_t, 2>;
  /// A triangle, and the pixels whose lines may meet it.
  struct Seen {
    std::uint32_t triangle;
    std::int16_t x0, x1, y0, y1;
  };
  /// A hit, and the line it is of.
  struct Found {
    std::uint32_t line;
    LineHit hit;
  };
  class Bands;
  void cast();
  /// Adds the hits of a triangle in some rows. Area: of the numbers that hold products of
  /// coordinates.
  template <class Area>
  void add_hits(const Seen& seen, int from, int to, std::vector<Found>& found) const;

  const Soup& soup_;
  Eigen::Matrix3d across_to_;
  int count_;
  Eigen::Vector2d low_;
  double pixel_;
  std::vector<Corner> across_;  // by vertex, in 2^-20 of a pixel
  std::vector<double> along_;   // by vertex, m
  bool near_ = true;            // all corners are by the raster
  std::vector<Seen> seen_;      // by the first row
};

/// Orthogonal directions of lines in general position: rows as Lines takes them; each of the three
/// k has another row last.
Eigen::Matrix3d line_frame(int k);

}  // namespace sonde
