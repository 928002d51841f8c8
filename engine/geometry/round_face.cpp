// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/round_face.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "engine/base/elementary.hpp"
#include "engine/base/ordering.hpp"

namespace sonde {
namespace {

constexpr double in_plane = 1e-6;  // 1 - cosine (0.08°): triangles of less are one piece
constexpr double sharp = 0.3;      // 1 - cosine (46°): pieces that meet at more are no round face
constexpr double smooth = 0.44;    // rad (25°): at an end, what bends by more is a chamfer
constexpr double hardly_bent = 0.1;     // of the curvature about an axis: that along it
constexpr double off_circle = 0.01;     // of the radius
constexpr double off_square = 0.02;     // of a normal along the axis
constexpr double largest_radius = 1e3;  // of the piece's size: more is as good as flat

/// The triangles at each vertex.
class Neighbours {
 public:
  explicit Neighbours(const Soup& soup) : soup_(soup), begin_(soup.vertices.size() + 1, 0) {
    for (const Triangle& t : soup.triangles)
      for (const std::uint32_t v : t) ++begin_[v + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    at_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t i = 0; i < soup.triangles.size(); ++i)
      for (const std::uint32_t v : soup.triangles[i]) at_[next[v]++] = i;
  }
  /// Calls use(other) for each other triangle at that side of one.
  template <class Use>
  void across(std::uint32_t triangle, std::uint32_t a, std::uint32_t b, Use use) const {
    for (std::size_t k = begin_[a]; k < begin_[a + 1]; ++k) {
      const Triangle& t = soup_.triangles[at_[k]];
      if (at_[k] != triangle && (t[0] == b || t[1] == b || t[2] == b)) use(at_[k]);
    }
  }

 private:
  const Soup& soup_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> at_;
};

Vec3 normal_of(const Soup& soup, std::uint32_t i) {
  const Triangle& t = soup.triangles[i];
  const Vec3& a = soup.vertices[t[0]];
  return (soup.vertices[t[1]] - a).cross(soup.vertices[t[2]] - a).stableNormalized();
}

/// Across the sides of some triangles, and on from there, while `take` says so.
template <class Take>
std::vector<std::uint32_t> spread(const Soup& soup, const Neighbours& next, std::uint32_t from,
                                  Take take) {
  std::vector<std::uint32_t> found{from};
  std::vector<bool> seen(soup.triangles.size(), false);
  seen[from] = true;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::uint32_t triangle = found[k];
    const Triangle& t = soup.triangles[triangle];
    for (std::size_t i = 0; i < 3; ++i)
      next.across(triangle, t[i], t[(i + 1) % 3], [&](std::uint32_t other) {
        if (seen[other] || !take(triangle, other)) return;
        seen[other] = true;
        found.push_back(other);
      });
  }
  return found;
}

/// What lies in the plane of a triangle and hangs together with it.
std::vector<std::uint32_t> flat_piece(const Soup& soup, const Neighbours& next,
                                      std::uint32_t triangle) {
  const Vec3 normal = normal_of(soup, triangle);
  return spread(soup, next, triangle, [&](std::uint32_t, std::uint32_t other) {
    return 1 - normal.dot(normal_of(soup, other)) <= in_plane;
  });
}

struct Circle {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double radius = 0;
};

/// By least squares in |x|² = 2 m·x + c (Kåsa, 1976).
Circle circle_through(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& x : points) mean += x;
  mean /= static_cast<double>(points.size());
  Eigen::MatrixX3d rows(points.size(), 3);
  Eigen::VectorXd squares(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d x = points[i] - mean;
    rows.row(static_cast<Eigen::Index>(i)) << 2 * x.x(), 2 * x.y(), 1;
    squares[static_cast<Eigen::Index>(i)] = x.squaredNorm();
  }
  const Eigen::Vector3d found = rows.colPivHouseholderQr().solve(squares);
  const Eigen::Vector2d middle = found.head<2>();
  return {middle + mean, std::sqrt(std::max(0.0, found[2] + middle.squaredNorm()))};
}

/// A plane square to an axis.
struct Across {
  Vec3 right, up;
  explicit Across(const Vec3& axis) {
    Eigen::Index least = 0;
    axis.cwiseAbs().minCoeff(&least);
    right = Vec3(Vec3::Unit(least) - axis * axis[least]).normalized();
    up = axis.cross(right);
  }
  Eigen::Vector2d at(const Vec3& x) const { return {x.dot(right), x.dot(up)}; }
};

std::vector<Eigen::Vector2d> corners_of(const Soup& soup, const std::vector<std::uint32_t>& of,
                                        const Across& plane) {
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t i : of)
    corners.insert(corners.end(), soup.triangles[i].begin(), soup.triangles[i].end());
  ordering::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::vector<Eigen::Vector2d> out;
  out.reserve(corners.size());
  for (const std::uint32_t v : corners) out.push_back(plane.at(soup.vertices[v]));
  return out;
}

/// The longest side at which a flat piece meets another at a blunt angle, and that other triangle.
struct Fold {
  double length = 0;
  Vec3 along = Vec3::Zero();
  std::uint32_t beyond = 0;
};

Fold longest_fold(const Soup& soup, const Neighbours& next,
                  const std::vector<std::uint32_t>& piece) {
  Fold best;
  for (const std::uint32_t i : piece) {
    const Triangle& t = soup.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      const Vec3 side = soup.vertices[b] - soup.vertices[a];
      next.across(i, a, b, [&](std::uint32_t other) {
        const double bend = 1 - normal_of(soup, i).dot(normal_of(soup, other));
        if (bend > in_plane && bend < sharp && side.norm() > best.length)
          best = {side.norm(), side.normalized(), other};
      });
    }
  }
  return best;
}

double turn_between(const Soup& soup, std::uint32_t a, std::uint32_t b) {
  return elementary::acos(std::clamp(normal_of(soup, a).dot(normal_of(soup, b)), -1.0, 1.0));
}

/// How much a flat piece and its like are bent along an axis too, 1/m: a strip of a sphere looks
/// like one of a cylinder, but for its ends, where the surface goes on smoothly.
double bend_along(const Soup& soup, const Neighbours& next, const std::vector<std::uint32_t>& piece,
                  const Vec3& axis) {
  double most = 0, low = std::numeric_limits<double>::infinity(), high = -low;
  for (const std::uint32_t i : piece) {
    const Triangle& t = soup.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const double along = axis.dot(soup.vertices[t[k]]);
      low = std::min(low, along), high = std::max(high, along);
      next.across(i, t[k], t[(k + 1) % 3], [&](std::uint32_t other) {
        if (turn_between(soup, i, other) < smooth)
          most = std::max(most, std::abs(normal_of(soup, other).dot(axis)));
      });
    }
  }
  return high > low ? most / (high - low) : 0;
}

}  // namespace

std::optional<RoundFace> round_face(const Soup& soup, std::uint32_t triangle) {
  const Neighbours next(soup);
  std::vector<std::uint32_t> piece = flat_piece(soup, next, triangle);
  const Fold fold = longest_fold(soup, next, piece);
  if (fold.length == 0) return std::nullopt;
  const std::vector<std::uint32_t> beyond = flat_piece(soup, next, fold.beyond);
  piece.insert(piece.end(), beyond.begin(), beyond.end());
  const Across plane(fold.along);
  Circle circle = circle_through(corners_of(soup, piece, plane));
  const auto on_circle = [&](std::uint32_t i) {
    return std::abs(normal_of(soup, i).dot(fold.along)) < off_square &&
           std::ranges::all_of(soup.triangles[i], [&](std::uint32_t v) {
             const double r = (plane.at(soup.vertices[v]) - circle.middle).norm();
             return std::abs(r - circle.radius) < off_circle * circle.radius;
           });
  };
  if (!(circle.radius < largest_radius * fold.length) || !std::ranges::all_of(piece, on_circle))
    return std::nullopt;
  if (bend_along(soup, next, piece, fold.along) * circle.radius > hardly_bent) return std::nullopt;
  const auto all = spread(soup, next, triangle,
                          [&](std::uint32_t, std::uint32_t other) { return on_circle(other); });
  circle = circle_through(corners_of(soup, all, plane));
  const Vec3 at = plane.right * circle.middle.x() + plane.up * circle.middle.y();
  // As far along the axis as the triangle that was asked about.
  const Vec3& beside = soup.vertices[soup.triangles[triangle][0]];
  return RoundFace{at + fold.along * fold.along.dot(beside), fold.along, circle.radius};
}

}  // namespace sonde
