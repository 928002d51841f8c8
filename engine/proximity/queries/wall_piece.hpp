// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde {

/// A line on which another triangle meets the plane of a wall, between two points.
struct WallCrossing {
  Vec3 from, to;
};

Vec3 wall_center(const Corners& wall);
/// m: the distance of the furthest corner from wall_center().
double wall_radius(const Corners& wall);

/// Adds the lines at which another triangle meets the plane of a wall, near the wall: where it
/// passes through, its side that lies in the plane, or all its sides. Points within `tolerance` (m)
/// of the plane count as in it.
void add_crossings(const Corners& wall, const Corners& other, double tolerance,
                   std::vector<WallCrossing>& out);

/// A convex piece of a triangle, as seen from a point.
class WallPiece {
 public:
  WallPiece(std::uint32_t triangle, const Corners& corners, const Vec3& from);

  std::uint32_t triangle() const { return triangle_; }
  double distance() const { return distance_; }  ///< m, from the point
  Vec3 nearest() const { return at(nearest_); }  ///< the point of it that is nearest
  /// A point at most `away` (m) from nearest(), inside the piece, on none of its edges.
  Vec3 nearest_within(double away) const;

  /// m: distance in the plane from its nearest point to a line; infinite if the line does not cross
  /// its interior by more than `tolerance` (m).
  double distance_to(const WallCrossing& line, double tolerance) const;
  /// The two parts of it on either side of a line that crosses its interior.
  std::array<WallPiece, 2> halves(const WallCrossing& line) const;

 private:
  using Vec2 = Eigen::Vector2d;
  struct Line {
    Vec2 from, along;  // along is unit
    double length;
    double side_of(const Vec2& x) const {
      return along.x() * (x - from).y() - along.y() * (x - from).x();
    }
  };
  Vec3 at(const Vec2& x) const { return origin_ + axes_ * x; }
  Vec2 in_plane(const Vec3& x) const { return axes_.transpose() * (x - origin_); }
  Line line_of(const WallCrossing& crossing) const;
  WallPiece side(const Line& line, double sign) const;
  void find_nearest();

  std::uint32_t triangle_;
  Vec3 origin_;
  Eigen::Matrix<double, 3, 2> axes_;  // of the plane, unit
  Vec2 from_;                         // the query point, projected onto the plane
  double height_;                     // m: of the query point over the plane
  std::vector<Vec2> corners_;         // anticlockwise
  Vec2 nearest_;
  double distance_ = 0;
};

}  // namespace sonde
