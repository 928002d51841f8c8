// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/wall_piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sonde {
namespace {

Eigen::Vector2d nearest_on(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                           const Eigen::Vector2d& x) {
  const Eigen::Vector2d ab = b - a;
  const double squared = ab.squaredNorm();
  if (!(squared > 0)) return a;
  return a + std::clamp(ab.dot(x - a) / squared, 0.0, 1.0) * ab;
}

}  // namespace

Vec3 wall_center(const Corners& wall) { return (wall[0] + wall[1] + wall[2]) / 3; }

double wall_radius(const Corners& wall) {
  const Vec3 center = wall_center(wall);
  return std::sqrt(std::max({(wall[0] - center).squaredNorm(), (wall[1] - center).squaredNorm(),
                             (wall[2] - center).squaredNorm()}));
}

void add_crossings(const Corners& wall, const Corners& other, double tolerance,
                   std::vector<WallCrossing>& out) {
  const Vec3 n = (wall[1] - wall[0]).cross(wall[2] - wall[0]).stableNormalized();
  std::array<double, 3> height;
  for (std::size_t i = 0; i < 3; ++i) {
    height[i] = n.dot(other[i] - wall[0]);
    if (std::abs(height[i]) <= tolerance) height[i] = 0;
  }
  if (height[0] == 0 && height[1] == 0 && height[2] == 0) {
    for (std::size_t i = 0; i < 3; ++i) out.push_back({other[i], other[(i + 1) % 3]});
    return;
  }
  std::array<Vec3, 3> ends;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (height[i] == 0) ends[count++] = other[i];
    if ((height[i] < 0 && height[j] > 0) || (height[i] > 0 && height[j] < 0))
      ends[count++] = other[i] + height[i] / (height[i] - height[j]) * (other[j] - other[i]);
  }
  if (count == 2) out.push_back({ends[0], ends[1]});
}

WallPiece::WallPiece(std::uint32_t triangle, const Corners& corners, const Vec3& from)
    : triangle_(triangle), origin_(corners[0]) {
  const Vec3 n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
  axes_.col(0) = (corners[1] - corners[0]).stableNormalized();
  axes_.col(1) = n.cross(axes_.col(0));
  from_ = in_plane(from);
  height_ = n.dot(from - origin_);
  for (const Vec3& corner : corners) corners_.push_back(in_plane(corner));
  find_nearest();
}

void WallPiece::find_nearest() {
  bool within = true;
  double least = std::numeric_limits<double>::infinity();
  nearest_ = corners_.front();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec2 &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
    const Vec2 ab = b - a, to = from_ - a;
    within = within && ab.x() * to.y() - ab.y() * to.x() >= 0;
    const Vec2 on_edge = nearest_on(a, b, from_);
    const double squared = (on_edge - from_).squaredNorm();
    if (squared < least) least = squared, nearest_ = on_edge;
  }
  if (within) least = 0, nearest_ = from_;
  distance_ = std::sqrt(least + height_ * height_);
}

Vec3 WallPiece::nearest_within(double away) const {
  Vec2 middle = Vec2::Zero();
  for (const Vec2& corner : corners_) middle += corner / static_cast<double>(corners_.size());
  const Vec2 way = middle - nearest_;
  const double length = way.norm();
  return at(length > 2 * away ? Vec2(nearest_ + away / length * way) : Vec2(nearest_ + 0.5 * way));
}

WallPiece::Line WallPiece::line_of(const WallCrossing& crossing) const {
  const Vec2 a = in_plane(crossing.from), b = in_plane(crossing.to);
  const double length = (b - a).norm();
  return {a, length > 0 ? Vec2((b - a) / length) : Vec2(Vec2::Zero()), length};
}

double WallPiece::distance_to(const WallCrossing& crossing, double tolerance) const {
  constexpr double never = std::numeric_limits<double>::infinity();
  const Line line = line_of(crossing);
  if (!(line.length > tolerance)) return never;
  double low = 0, high = 0;
  for (const Vec2& corner : corners_) {
    const double side = line.side_of(corner);
    low = std::min(low, side), high = std::max(high, side);
  }
  if (!(low < -tolerance && high > tolerance)) return never;
  // The part of the line that is inside all edges by more than the tolerance.
  double begin = 0, end = line.length;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec2 &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
    const double edge = (b - a).norm();
    if (!(edge > 0)) continue;
    const Vec2 inwards = Vec2(a.y() - b.y(), b.x() - a.x()) / edge;
    const double depth = inwards.dot(line.from - a) - tolerance, rise = inwards.dot(line.along);
    if (rise > 0)
      begin = std::max(begin, -depth / rise);
    else if (rise < 0)
      end = std::min(end, -depth / rise);
    else if (depth < 0)
      return never;
  }
  if (!(end - begin > tolerance)) return never;
  return (nearest_on(line.from + begin * line.along, line.from + end * line.along, nearest_) -
          nearest_)
      .norm();
}

/// The part whose points are on the side of that sign.
WallPiece WallPiece::side(const Line& line, double sign) const {
  WallPiece out = *this;
  out.corners_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vec2 &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
    const double at_a = sign * line.side_of(a), at_b = sign * line.side_of(b);
    if (at_a >= 0) out.corners_.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
      out.corners_.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  out.find_nearest();
  return out;
}

std::array<WallPiece, 2> WallPiece::halves(const WallCrossing& crossing) const {
  const Line line = line_of(crossing);
  return {side(line, 1), side(line, -1)};
}

}  // namespace sonde
