// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/wide_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sonde::test {
namespace {

struct Point {
  Wide x, y, z;
};
Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator*(Wide s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }
Wide dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Wide clamp01(Wide x) { return x < 0 ? 0 : (x > 1 ? 1 : x); }

/// By one step of Newton's from the root in double.
Wide root(Wide x) {
  const Wide y = std::sqrt(static_cast<double>(x));
  return y > 0 ? (y + x / y) / 2 : y;
}

using Triangle = std::array<Point, 3>;
Triangle widen(const Corners& t) {
  Triangle out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = {t[i].x(), t[i].y(), t[i].z()};
  return out;
}

struct Nearest {
  Wide squared = std::numeric_limits<double>::infinity();
  Point a{}, b{};
  void offer(const Point& on_a, const Point& on_b) {
    const Wide d = dot(on_a - on_b, on_a - on_b);
    if (d < squared) squared = d, a = on_a, b = on_b;
  }
};

/// The best of what the normal equations give and of each end with its foot on the other: any of
/// them is a pair of points of the segments.
void segments(const Point& p, const Point& p1, const Point& q, const Point& q1, Nearest& best) {
  const Point u = p1 - p, w = q1 - q, r = p - q;
  const Wide uu = dot(u, u), ww = dot(w, w), uw = dot(u, w), ur = dot(u, r), wr = dot(w, r);
  const auto foot_on_u = [&](Wide t) { return uu > 0 ? clamp01((uw * t - ur) / uu) : 0; };
  const auto foot_on_w = [&](Wide s) { return ww > 0 ? clamp01((uw * s + wr) / ww) : 0; };
  const Wide det = uu * ww - uw * uw;
  const Wide inner = det > 0 ? clamp01((uw * wr - ur * ww) / det) : 0;
  for (const Wide s : {Wide{0}, Wide{1}, inner}) best.offer(p + s * u, q + foot_on_w(s) * w);
  for (const Wide t : {Wide{0}, Wide{1}}) best.offer(p + foot_on_u(t) * u, q + t * w);
}

/// The foot of x on the face as a mean of the corners, by weights that are areas seen along the
/// normal: a point of the triangle however they are rounded. False where one is negative.
bool point_over(const Triangle& t, const Point& x, Point& foot) {
  const Point n = cross(t[1] - t[0], t[2] - t[0]);
  std::array<Wide, 3> weight;
  Wide sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &p = t[(i + 1) % 3], &q = t[(i + 2) % 3];
    weight[i] = dot(cross(q - p, x - p), n);
    if (weight[i] < 0) return false;
    sum += weight[i];
  }
  if (!(sum > 0)) return false;
  foot = t[0] + (weight[1] / sum) * (t[1] - t[0]) + (weight[2] / sum) * (t[2] - t[0]);
  return true;
}

/// A point of the face on one of the other's edges.
bool pierced(const Triangle& face, const Triangle& other, Nearest& best) {
  const Point n = cross(face[1] - face[0], face[2] - face[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &p = other[i], &q = other[(i + 1) % 3];
    const Wide h = dot(n, p - face[0]), k = dot(n, q - face[0]);
    if ((h > 0) == (k > 0)) continue;
    Point foot;
    const Point x = p + (h / (h - k)) * (q - p);
    if (!point_over(face, x, foot)) continue;
    best.offer(x, foot);
    return true;
  }
  return false;
}

}  // namespace

WideBounds wide_distance(const Corners& corners_a, const Corners& corners_b) {
  const Triangle a = widen(corners_a), b = widen(corners_b);
  Nearest best;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) segments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3], best);
  Point foot;
  for (std::size_t i = 0; i < 3; ++i) {
    if (point_over(b, a[i], foot)) best.offer(a[i], foot);
    if (point_over(a, b[i], foot)) best.offer(foot, b[i]);
  }
  if (!pierced(a, b, best)) pierced(b, a, best);
  const Wide upper = root(best.squared);
  if (!(upper > 0)) return {0, 0};
  const Point way = best.a - best.b;
  Wide low = dot(way, a[0] - best.b), high = dot(way, b[0] - best.b);
  for (const Point& x : a) low = std::min(low, dot(way, x - best.b));
  for (const Point& x : b) high = std::max(high, dot(way, x - best.b));
  const Wide lower = (low - high) / upper;
  return {static_cast<double>(lower > 0 ? lower : 0), static_cast<double>(upper)};
}

double wide_distance(const Vec3& x, const Corners& t) {
  return wide_distance(Corners{x, x, x}, t).upper;
}

}  // namespace sonde::test
