// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/separating_axes.hpp"

#include <cmath>

namespace sonde {
namespace {

/// Share of a gap: corners whose heights differ by less are equally low.
constexpr double as_low = 1e-6;

class Axes {
 public:
  Axes(const Corners& a, const Corners& b, const Vec3& normal, double least)
      : a_(a), b_(b), normal_(normal), least_(least) {}

  OtherAxes find() {
    for (const double side : {1, -1}) {
      // The plane of B stays as the probe moves, and its lowest corner is the nearest to it. The
      // plane of A goes with the probe, and the corner of B below it stays.
      if (const Vec3 n = side * unit(area_normal(b_)); n.squaredNorm() > 0)
        add(n, lowest_corner(a_, n));
      if (const Vec3 n = side * unit(area_normal(a_)); n.squaredNorm() > 0)
        add(n, lowest_corner(b_, -n) + gap_along(n, a_, b_) * n);
    }
    any_edges(a_, b_, [&](const Vec3& axis, std::size_t i, std::size_t j) {
      return add_edges(axis, i, j), false;
    });
    return out_;
  }

 private:
  static Vec3 unit(const Vec3& v) { return v.squaredNorm() > 0 ? v.normalized() : v; }

  void add(const Vec3& n, const Vec3& on_probe) {
    const double gap = gap_along(n, a_, b_);
    if (!(gap >= least_) || n.dot(normal_) > contact_tuning.same_normal) return;
    out_.items[out_.size++] = {on_probe, on_probe - gap * n, n, gap, 0};
  }

  void add_edges(const Vec3& axis, std::size_t i, std::size_t j) {
    for (const double side : {1, -1}) {
      const Vec3 n = side * axis.normalized();
      if (const auto on_probe = point_between_edges(a_, i, b_, j, axis, n, gap_along(n, a_, b_)))
        add(n, *on_probe);
    }
  }

  const Corners& a_;
  const Corners& b_;
  const Vec3& normal_;
  double least_;
  OtherAxes out_;
};

}  // namespace

std::optional<Vec3> point_between_edges(const Corners& a, std::size_t i, const Corners& b,
                                        std::size_t j, const Vec3& axis, const Vec3& n,
                                        double gap) noexcept {
  const double same = as_low * std::abs(gap);
  const Vec3 &low = lowest_corner(a, n), &high = lowest_corner(b, -n);
  if (n.dot(a[i] - low) > same) return low;
  if (n.dot(high - b[j]) > same) return std::nullopt;
  // (a + s u − b) is along n + v: the part of it across both is 0.
  const double s = (b[j] - a[i]).cross(edge_of(b, j)).dot(axis) / axis.squaredNorm();
  return a[i] + s * edge_of(a, i);
}

OtherAxes other_axes(const Corners& a, const Corners& b, const Vec3& normal,
                     double least) noexcept {
  return Axes(a, b, normal, least).find();
}

}  // namespace sonde
