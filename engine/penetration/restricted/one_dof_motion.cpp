// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/restricted/one_dof_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/elementary.hpp"
#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// Whether all corners of a triangle lie in the plane of another.
bool lies_in_plane(const Corners& a, const Corners& b, double flat) {
  const Vec3 n = area_normal(b).normalized();
  return std::ranges::all_of(a, [&](const Vec3& x) { return std::abs(n.dot(x - b[0])) <= flat; });
}

}  // namespace

OneDofMotion OneDofMotion::along(const Pose& X_FM, const Vec3& direction_F) {
  OneDofMotion out;
  out.start_ = X_FM;
  out.direction_ = direction_F;
  return out;
}

OneDofMotion OneDofMotion::about(const Pose& X_FM, const Vec3& point_F, const Vec3& axis_F) {
  OneDofMotion out = along(X_FM, axis_F);
  out.turns_ = true;
  out.point_ = point_F;
  return out;
}

OneDofMotion OneDofMotion::back() const {
  OneDofMotion out = *this;
  out.direction_ = -direction_;
  return out;
}

Pose OneDofMotion::at(double s) const {
  if (!turns_) return {start_.q, start_.p + s * direction_};
  const Quat turn = rotation_about(direction_, s);
  return {(turn * start_.q).normalized(), point_ + turn * (start_.p - point_)};
}

double OneDofMotion::speed(const Vec3& center, double radius) const {
  return turns_ ? direction_.cross(start_ * center - point_).norm() + radius : 1;
}

Corners OneDofMotion::moved(const Corners& a, double s) const {
  const Transform there(at(s)), back(inverse(start_));
  Corners out = a;
  for (Vec3& x : out) x = there * (back * x);
  return out;
}

OneDofMotion::Coordinate OneDofMotion::of_turned(const Vec3& n, const Vec3& w) const {
  const Vec3 along = direction_ * direction_.dot(w);
  return {n.dot(w - along), n.dot(direction_.cross(w)), n.dot(along)};
}

OneDofMotion::Coordinate OneDofMotion::of_point(const Vec3& n, const Vec3& x) const {
  if (!turns_) return {n.dot(x), n.dot(direction_), 0};
  Coordinate out = of_turned(n, x - point_);
  out.rest += n.dot(point_);
  return out;
}

OneDofMotion::Coordinate OneDofMotion::of_plane(const Vec3& n, const Vec3& x, const Vec3& b) const {
  if (!turns_) return {n.dot(b - x), -n.dot(direction_), 0};
  Coordinate out = of_turned(b - point_, n);
  out.rest -= n.dot(x - point_);
  return out;
}

OneDofMotion::Coordinate OneDofMotion::of_edges(const Vec3& p, const Vec3& e, const Vec3& q,
                                                const Vec3& f) const {
  if (!turns_) return {e.cross(f).dot(q - p), -e.cross(f).dot(direction_), 0};
  return of_turned(f.cross(q - point_), e) - of_turned(f, (p - point_).cross(e));
}

OneDofMotion::Interval::Interval(double first, double last)
    : from(first),
      to(last),
      cosine(elementary::cos(0.5 * (first + last))),
      sine(elementary::sin(0.5 * (first + last))) {}

void OneDofMotion::add_roots(const Coordinate& c, const Interval& interval,
                             std::vector<double>& out) const {
  const auto add = [&](double s) {
    if (s > interval.from && s < interval.to) out.push_back(s);
  };
  if (!turns_) {
    if (c.odd != 0) add(-c.even / c.odd);
    return;
  }
  const double size = std::sqrt(c.even * c.even + c.odd * c.odd);
  // Early exit, which applies to most: the slope is at most `size` per radian, so a value this
  // large at the middle excludes a root in the interval.
  const double at_middle = c.even * interval.cosine + c.odd * interval.sine + c.rest;
  if (!(size > 0) || std::abs(c.rest) > size ||
      std::abs(at_middle) > 0.51 * size * (interval.to - interval.from))
    return;
  const double first = elementary::atan2(c.odd, c.even), half = elementary::acos(-c.rest / size);
  for (const double root : {first - half, first + half})
    for (const double round : {-1.0, 0.0, 1.0}) add(root + round * 2 * std::numbers::pi);
}

void OneDofMotion::events(const Corners& a, const Corners& b, const Interval& interval, double flat,
                          std::vector<double>& out) const {
  const Vec3 n_a = area_normal(a), n_b = area_normal(b);
  for (std::size_t i = 0; i < 3; ++i) {
    Coordinate above = of_point(n_b, a[i]);
    (turns_ ? above.rest : above.even) -= n_b.dot(b[0]);
    add_roots(above, interval, out);
    add_roots(of_plane(n_a, a[0], b[i]), interval, out);
    for (std::size_t j = 0; j < 3; ++j)
      add_roots(of_edges(a[i], a[(i + 1) % 3] - a[i], b[j], b[(j + 1) % 3] - b[j]), interval, out);
  }
  // Not coplanar throughout: then the planes through corners already give all events.
  if (!lies_in_plane(moved(a, interval.from), b, flat) ||
      !lies_in_plane(moved(a, interval.to), b, flat))
    return;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3 side_a = n_a.cross(a[(j + 1) % 3] - a[j]);
    const Vec3 side_b = n_b.cross(b[(j + 1) % 3] - b[j]);
    for (std::size_t i = 0; i < 3; ++i) {
      Coordinate above = of_point(side_b, a[i]);
      (turns_ ? above.rest : above.even) -= side_b.dot(b[j]);
      add_roots(above, interval, out);
      add_roots(of_plane(side_a, a[j], b[i]), interval, out);
    }
  }
}

}  // namespace sonde
