// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/touching_points.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/numbers.hpp"
#include "engine/penetration/contact/contact_tuning.hpp"

namespace sonde {
namespace {

using Vec2 = Eigen::Vector2d;

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

/// One to three corners of a triangle, and their positions seen along the normal.
struct Feature {
  std::array<Vec3, 3> corner;
  std::array<Vec2, 3> seen;
  std::size_t size = 0;
  std::size_t edges() const { return size == 3 ? 3 : size - 1; }
  std::size_t next(std::size_t i) const { return (i + 1) % size; }
};

/// The corners of a triangle within `slack` of its foremost point in the direction `to`.
Feature foremost(const Corners& t, const Vec3& to, const Vec3& u, const Vec3& w, double slack) {
  const double most = std::max({to.dot(t[0]), to.dot(t[1]), to.dot(t[2])});
  Feature out;
  for (const Vec3& x : t) {
    if (to.dot(x) < most - slack) continue;
    out.corner[out.size] = x;
    out.seen[out.size++] = {u.dot(x), w.dot(x)};
  }
  return out;
}

struct Nearest {
  Vec3 point = Vec3::Zero();
  double distance = infinity;  ///< seen along the normal
};

/// The point of a feature that is nearest to p, seen along the normal.
Nearest nearest(const Feature& on, const Vec2& p) {
  if (on.size == 3) {
    const Vec2 e = on.seen[1] - on.seen[0], f = on.seen[2] - on.seen[0], d = p - on.seen[0];
    const double area = cross(e, f);
    const double s = cross(d, f) / area, t = cross(e, d) / area;
    if (s >= 0 && t >= 0 && s + t <= 1)
      return {on.corner[0] + s * (on.corner[1] - on.corner[0]) + t * (on.corner[2] - on.corner[0]),
              0};
  }
  if (on.size == 1) return {on.corner[0], (p - on.seen[0]).norm()};
  Nearest out;
  for (std::size_t i = 0; i < on.edges(); ++i) {
    const std::size_t j = on.next(i);
    const Vec2 along = on.seen[j] - on.seen[i];
    const double length2 = along.squaredNorm();
    const double s = length2 > 0 ? std::clamp((p - on.seen[i]).dot(along) / length2, 0.0, 1.0) : 0;
    const double distance = (on.seen[i] + s * along - p).norm();
    if (distance < out.distance) out = {on.corner[i] + s * (on.corner[j] - on.corner[i]), distance};
  }
  return out;
}

/// Adds the crossings of edges. Parallel edges give none: their ends are corners of the common
/// part.
void cross_edges(const Feature& a, const Feature& b, const Vec3& normal, TouchingPoints& out) {
  for (std::size_t i = 0; i < a.edges(); ++i)
    for (std::size_t j = 0; j < b.edges(); ++j) {
      const Vec2 p = a.seen[a.next(i)] - a.seen[i], q = b.seen[b.next(j)] - b.seen[j];
      const double turn = cross(p, q);
      if (!(std::abs(turn) > contact_tuning.parallel_edges * p.norm() * q.norm())) continue;
      const Vec2 way = b.seen[j] - a.seen[i];
      const double s = cross(way, q) / turn, t = cross(way, p) / turn;
      if (s < 0 || s > 1 || t < 0 || t > 1) continue;
      out.push(a.corner[i] + s * (a.corner[a.next(i)] - a.corner[i]),
               b.corner[j] + t * (b.corner[b.next(j)] - b.corner[j]), normal);
    }
}

}  // namespace

TouchingPoints touching_points(const Corners& a, const Corners& b, const Vec3& normal,
                               double slack) {
  const Vec3 u = normal.unitOrthogonal(), w = normal.cross(u);
  const Feature lowest = foremost(a, -normal, u, w, slack);
  const Feature highest = foremost(b, normal, u, w, slack);
  TouchingPoints out;
  for (std::size_t i = 0; i < lowest.size; ++i)
    if (const Nearest p = nearest(highest, lowest.seen[i]); p.distance <= slack)
      out.push(lowest.corner[i], p.point, normal);
  for (std::size_t i = 0; i < highest.size; ++i)
    if (const Nearest p = nearest(lowest, highest.seen[i]); p.distance <= slack)
      out.push(p.point, highest.corner[i], normal);
  cross_edges(lowest, highest, normal, out);
  if (out.size > 0) return out;
  const auto before = [&](const Vec3& x, const Vec3& y) { return normal.dot(x) < normal.dot(y); };
  out.push(*std::min_element(a.begin(), a.end(), before),
           *std::max_element(b.begin(), b.end(), before), normal);
  return out;
}

}  // namespace sonde
