// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/half_spaces.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sonde {
namespace {

/// Normals whose cross product is shorter than this are parallel.
constexpr double parallel = 1e-10;
/// A line along a plane, to rounding, meets it nowhere.
constexpr double along = 1e-12;
/// Planes through one point leave an interval of rounding on a line of theirs.
constexpr double pinched = 1e3;

/// Far apart in the order of a mesh, where neighbours would undo each other's work: steps of the
/// golden section, each index once.
std::vector<std::size_t> scattered(std::size_t n) {
  auto step = std::max<std::size_t>(1, static_cast<std::size_t>(0.618 * static_cast<double>(n)));
  while (std::gcd(step, n) != 1) ++step;
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i * step % n;
  return order;
}

/// The half-spaces one after another: where the nearest point so far misses the next, the new one
/// is on its plane (Seidel's linear programming, 1991, for a distance). Expected time linear.
class Nearest {
 public:
  Nearest(const std::vector<HalfSpace3>& spaces, const Vec3& from, double rounding)
      : spaces_(spaces), order_(scattered(spaces.size())), from_(from), rounding_(rounding) {}

  std::optional<Vec3> find() const {
    Vec3 x = from_;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (missed_by(i, x) <= rounding_) continue;
      const std::optional<Vec3> on = on_plane(i);
      if (!on) return std::nullopt;
      x = *on;
    }
    return x;
  }

 private:
  const HalfSpace3& at(std::size_t i) const { return spaces_[order_[i]]; }
  double missed_by(std::size_t i, const Vec3& x) const { return at(i).least - at(i).normal.dot(x); }

  /// Of the half-spaces before i, on the plane of i.
  std::optional<Vec3> on_plane(std::size_t i) const {
    Vec3 x = from_ + missed_by(i, from_) * at(i).normal;
    for (std::size_t j = 0; j < i; ++j) {
      if (missed_by(j, x) <= rounding_) continue;
      const std::optional<Vec3> on = on_line(i, j);
      if (!on) return std::nullopt;
      x = *on;
    }
    return x;
  }

  /// Of the half-spaces before j, on the planes of i and j.
  std::optional<Vec3> on_line(std::size_t i, std::size_t j) const {
    const Vec3 &n_i = at(i).normal, &n_j = at(j).normal;
    const Vec3 cross = n_i.cross(n_j);
    const double square = cross.squaredNorm();
    if (square < parallel * parallel) {
      if (n_i.dot(n_j) < 0) return std::nullopt;
      return from_ + missed_by(j, from_) * n_j;
    }
    const double g = n_i.dot(n_j), a = missed_by(i, from_), b = missed_by(j, from_);
    const Vec3 x = from_ + (a - g * b) / square * n_i + (b - g * a) / square * n_j;
    return within(x, cross / std::sqrt(square), j);
  }

  /// Of the half-spaces before `end`, on a line through x, its nearest point.
  std::optional<Vec3> within(const Vec3& x, const Vec3& direction, std::size_t end) const {
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    double low_slope = 0, high_slope = 0;
    for (std::size_t k = 0; k < end; ++k) {
      const double slope = at(k).normal.dot(direction), missed = missed_by(k, x);
      if (std::abs(slope) < along) {
        if (missed > pinched * rounding_) return std::nullopt;
      } else if (slope > 0 && missed / slope > low) {
        low = missed / slope;
        low_slope = slope;
      } else if (slope < 0 && missed / slope < high) {
        high = missed / slope;
        high_slope = -slope;
      }
    }
    if (low > high) {
      if ((low - high) * std::max(low_slope, high_slope) > pinched * rounding_) return std::nullopt;
      return x + (low + high) / 2 * direction;
    }
    return x + std::clamp(0.0, low, high) * direction;
  }

  const std::vector<HalfSpace3>& spaces_;
  std::vector<std::size_t> order_;
  Vec3 from_;
  double rounding_;
};

}  // namespace

std::optional<Vec3> nearest_in(const std::vector<HalfSpace3>& spaces, const Vec3& from,
                               double rounding) {
  if (spaces.empty()) return from;
  return Nearest(spaces, from, rounding).find();
}

Vec3 nearest_to_planes(const std::vector<HalfSpace3>& spaces) {
  Mat3 squares = Mat3::Zero();
  Vec3 sums = Vec3::Zero();
  for (const HalfSpace3& space : spaces) {
    squares += space.normal * space.normal.transpose();
    sums += space.least * space.normal;
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(squares);
  constexpr double flat = 1e-10;  // of normals that differ by 1e-5 rad
  Vec3 x = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    const Vec3 axis = solver.eigenvectors().col(i);
    if (value > flat * solver.eigenvalues()[2]) x += axis.dot(sums) / value * axis;
  }
  return x;
}

}  // namespace sonde
