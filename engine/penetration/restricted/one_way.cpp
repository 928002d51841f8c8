// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/restricted/one_way.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/elementary.hpp"
#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// The normal, with twice the triangle's area as its length.
Vec3 normal_of(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// Whether all corners of a triangle lie in the plane of another.
bool lies_in_plane(const Corners& a, const Corners& b, double flat) {
  const Vec3 n = normal_of(b).normalized();
  return std::ranges::all_of(a, [&](const Vec3& x) { return std::abs(n.dot(x - b[0])) <= flat; });
}

}  // namespace

OneWay OneWay::along(const Pose& X_FM, const Vec3& direction_F) {
  OneWay out;
  out.start_ = X_FM;
  out.way_ = direction_F;
  return out;
}

OneWay OneWay::about(const Pose& X_FM, const Vec3& point_F, const Vec3& axis_F) {
  OneWay out = along(X_FM, axis_F);
  out.turns_ = true;
  out.point_ = point_F;
  return out;
}

OneWay OneWay::back() const {
  OneWay out = *this;
  out.way_ = -way_;
  return out;
}

Pose OneWay::at(double s) const {
  if (!turns_) return {start_.q, start_.p + s * way_};
  const Quat turn = rotation_about(way_, s);
  return {(turn * start_.q).normalized(), point_ + turn * (start_.p - point_)};
}

double OneWay::speed(const Vec3& center, double radius) const {
  return turns_ ? way_.cross(start_ * center - point_).norm() + radius : 1;
}

Corners OneWay::moved(const Corners& a, double s) const {
  const Transform there(at(s)), back(inverse(start_));
  Corners out = a;
  for (Vec3& x : out) x = there * (back * x);
  return out;
}

OneWay::Course OneWay::of_turned(const Vec3& n, const Vec3& w) const {
  const Vec3 along = way_ * way_.dot(w);
  return {n.dot(w - along), n.dot(way_.cross(w)), n.dot(along)};
}

OneWay::Course OneWay::of_point(const Vec3& n, const Vec3& x) const {
  if (!turns_) return {n.dot(x), n.dot(way_), 0};
  Course out = of_turned(n, x - point_);
  out.rest += n.dot(point_);
  return out;
}

OneWay::Course OneWay::of_plane(const Vec3& n, const Vec3& x, const Vec3& b) const {
  if (!turns_) return {n.dot(b - x), -n.dot(way_), 0};
  Course out = of_turned(b - point_, n);
  out.rest -= n.dot(x - point_);
  return out;
}

OneWay::Course OneWay::of_edges(const Vec3& p, const Vec3& e, const Vec3& q, const Vec3& f) const {
  if (!turns_) return {e.cross(f).dot(q - p), -e.cross(f).dot(way_), 0};
  return of_turned(f.cross(q - point_), e) - of_turned(f, (p - point_).cross(e));
}

OneWay::Stretch::Stretch(double first, double last)
    : from(first),
      to(last),
      cosine(elementary::cos(0.5 * (first + last))),
      sine(elementary::sin(0.5 * (first + last))) {}

void OneWay::add_roots(const Course& c, const Stretch& stretch, std::vector<double>& out) const {
  const auto add = [&](double s) {
    if (s > stretch.from && s < stretch.to) out.push_back(s);
  };
  if (!turns_) {
    if (c.odd != 0) add(-c.even / c.odd);
    return;
  }
  const double size = std::sqrt(c.even * c.even + c.odd * c.odd);
  // Early exit, which applies to most: the slope is at most `size` per radian, so a value this
  // large at the middle excludes a root in the stretch.
  const double at_middle = c.even * stretch.cosine + c.odd * stretch.sine + c.rest;
  if (!(size > 0) || std::abs(c.rest) > size ||
      std::abs(at_middle) > 0.51 * size * (stretch.to - stretch.from))
    return;
  const double first = elementary::atan2(c.odd, c.even), half = elementary::acos(-c.rest / size);
  for (const double root : {first - half, first + half})
    for (const double round : {-1.0, 0.0, 1.0}) add(root + round * 2 * std::numbers::pi);
}

void OneWay::events(const Corners& a, const Corners& b, const Stretch& stretch, double flat,
                    std::vector<double>& out) const {
  const Vec3 n_a = normal_of(a), n_b = normal_of(b);
  for (std::size_t i = 0; i < 3; ++i) {
    Course above = of_point(n_b, a[i]);
    (turns_ ? above.rest : above.even) -= n_b.dot(b[0]);
    add_roots(above, stretch, out);
    add_roots(of_plane(n_a, a[0], b[i]), stretch, out);
    for (std::size_t j = 0; j < 3; ++j)
      add_roots(of_edges(a[i], a[(i + 1) % 3] - a[i], b[j], b[(j + 1) % 3] - b[j]), stretch, out);
  }
  // Not coplanar throughout: then the planes through corners already give all events.
  if (!lies_in_plane(moved(a, stretch.from), b, flat) ||
      !lies_in_plane(moved(a, stretch.to), b, flat))
    return;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3 side_a = n_a.cross(a[(j + 1) % 3] - a[j]);
    const Vec3 side_b = n_b.cross(b[(j + 1) % 3] - b[j]);
    for (std::size_t i = 0; i < 3; ++i) {
      Course above = of_point(side_b, a[i]);
      (turns_ ? above.rest : above.even) -= side_b.dot(b[j]);
      add_roots(above, stretch, out);
      add_roots(of_plane(side_a, a[j], b[i]), stretch, out);
    }
  }
}

}  // namespace sonde
