// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/triangle_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sonde {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double clamp01(double x) { return x < 0 ? 0 : (x > 1 ? 1 : x); }

struct Best {
  Vec3 a, b;
  double squared = std::numeric_limits<double>::infinity();
  void offer(const Vec3& on_a, const Vec3& on_b) {
    const double d = (on_a - on_b).squaredNorm();
    if (d < squared) squared = d, a = on_a, b = on_b;
  }
};

/// Closest points of segments p + s u and q + t w, s and t in [0, 1]; either may be a point.
void segment_segment(const Vec3& p, const Vec3& u, double uu, const Vec3& q, const Vec3& w,
                     double ww, Best& best) {
  const Vec3 r = p - q;
  const double ur = u.dot(r), wr = w.dot(r), uw = u.dot(w);
  const double determinant = uu * ww - uw * uw;
  if (determinant <= 1e-8 * uu * ww) {
    // Nearly parallel: s below is lost to rounding, and one end or another is about as near. Of a
    // point and a segment both ends of the point are.
    const auto end = [&](double s) {
      best.offer(p + s * u, q + clamp01(ww > 0 ? (uw * s + wr) / ww : 0.0) * w);
    };
    const auto other_end = [&](double t) {
      best.offer(p + clamp01(uu > 0 ? (uw * t - ur) / uu : 0.0) * u, q + t * w);
    };
    end(0), end(1), other_end(0), other_end(1);
  }
  double s = determinant > 1e-14 * uu * ww ? clamp01((uw * wr - ur * ww) / determinant) : 0.0;
  double t = ww > 0 ? (uw * s + wr) / ww : 0.0;
  if (t < 0 || t > 1) {
    t = clamp01(t);
    s = uu > 0 ? clamp01((uw * t - ur) / uu) : 0.0;
  }
  best.offer(p + s * u, q + t * w);
}

/// A triangle with what its candidates share.
struct Face {
  const Corners& v;
  std::array<Vec3, 3> edge;  // edge i runs from corner i to corner i + 1
  std::array<double, 3> length2;
  Vec3 normal;
  double normal2;
  /// Heights of the other triangle's corners over the plane, times |normal|.
  std::array<double, 3> height{};
  Face(const Corners& t, const Corners& other) : v(t) {
    for (std::size_t i = 0; i < 3; ++i) {
      edge[i] = t[(i + 1) % 3] - t[i];
      length2[i] = edge[i].squaredNorm();
    }
    normal = edge[0].cross(edge[1]);
    square_to_longest_edge();
    normal2 = normal.squaredNorm();
    for (std::size_t i = 0; i < 3; ++i) height[i] = normal.dot(other[i] - t[0]);
  }
  /// The normal of a needle is turned by the rounding of the product, by as much as a right angle.
  /// Turned about the needle that does no harm; what leans along it is taken out, and nothing left
  /// means no face.
  void square_to_longest_edge() {
    std::size_t longest = length2[1] > length2[0] ? 1 : 0;
    if (length2[2] > length2[longest]) longest = 2;
    if (!(length2[longest] > 0)) return;
    const double before = normal.squaredNorm();
    normal -= normal.dot(edge[longest]) / length2[longest] * edge[longest];
    if (normal.squaredNorm() < 0.25 * before) normal.setZero();
  }
  bool all_above() const { return height[0] > 0 && height[1] > 0 && height[2] > 0; }
  bool all_below() const { return height[0] < 0 && height[1] < 0 && height[2] < 0; }
  /// Is the other triangle on one side of the plane, further from it than limit?
  bool beyond(double limit) const {
    if (!(all_above() || all_below())) return false;
    const double nearest =
        std::min({std::abs(height[0]), std::abs(height[1]), std::abs(height[2])});
    return nearest * nearest > limit * limit * normal2 * (1 + 1e-12);
  }
  /// Is x, seen along the normal, inside?
  bool covers(const Vec3& x) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (edge[i].cross(x - v[i]).dot(normal) < 0) return false;
    return true;
  }
};

/// Corners of `other` over the inside of `face`, and edges of `other` through it. `swap`: face is
/// of B.
bool over_face(const Face& face, const Corners& other, bool swap, Best& best) {
  if (face.normal2 <= 0) return false;
  const std::array<double, 3>& height = face.height;
  for (std::size_t i = 0; i < 3; ++i) {
    // A corner further than the best so far cannot improve on it.
    if (height[i] * height[i] > best.squared * face.normal2 || !face.covers(other[i])) continue;
    const Vec3 foot = other[i] - (height[i] / face.normal2) * face.normal;
    swap ? best.offer(other[i], foot) : best.offer(foot, other[i]);
  }
  if (face.all_above() || face.all_below()) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if ((height[i] > 0) == (height[j] > 0)) continue;
    const Vec3 x = other[i] + (height[i] / (height[i] - height[j])) * (other[j] - other[i]);
    if (!face.covers(x)) continue;
    best = {x, x, 0};
    return true;
  }
  return false;
}

double largest_coordinate(const Corners& t) {
  double m = 0;
  for (const Vec3& x : t) m = std::max(m, x.cwiseAbs().maxCoeff());
  return m;
}

/// Sign of a determinant with its rounding error: 0 where in doubt.
int sign(double value, double error) { return value > error ? 1 : (value < -error ? -1 : 0); }

/// orient3d(a, b, c, d) in double with a forward error bound: products of three differences, each
/// difference within epsilon of its value; 1e-15 of the permanent bounds all of it (Shewchuk 1997
/// has 7.8e-16 for the determinant of exact differences' roundings).
int orient(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double m1 = v.x() * w.y(), m2 = w.x() * v.y(), m3 = w.x() * u.y(), m4 = u.x() * w.y(),
               m5 = u.x() * v.y(), m6 = v.x() * u.y();
  const double det = u.z() * (m1 - m2) + v.z() * (m3 - m4) + w.z() * (m5 - m6);
  const double permanent = (std::abs(m1) + std::abs(m2)) * std::abs(u.z()) +
                           (std::abs(m3) + std::abs(m4)) * std::abs(v.z()) +
                           (std::abs(m5) + std::abs(m6)) * std::abs(w.z());
  return sign(det, 1e-15 * permanent);
}

/// Does an edge of `other` certainly pierce `face`?
bool pierces(const Corners& face, const Corners& other) {
  std::array<int, 3> side;
  for (std::size_t i = 0; i < 3; ++i) side[i] = orient(face[0], face[1], face[2], other[i]);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (side[i] * side[j] >= 0) continue;
    const int s0 = orient(other[i], other[j], face[0], face[1]);
    if (s0 == 0) continue;
    if (orient(other[i], other[j], face[1], face[2]) == s0 &&
        orient(other[i], other[j], face[2], face[0]) == s0)
      return true;
  }
  return false;
}

}  // namespace

ClosestPoints closest_points(const Corners& a, const Corners& b, double limit) {
  const Face face_a(a, b), face_b(b, a);
  if (face_a.beyond(limit) || face_b.beyond(limit))
    return {Vec3::Zero(), Vec3::Zero(), std::numeric_limits<double>::infinity()};
  Best best;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      segment_segment(a[i], face_a.edge[i], face_a.length2[i], b[j], face_b.edge[j],
                      face_b.length2[j], best);
  if (!over_face(face_a, b, false, best)) over_face(face_b, a, true, best);
  return {best.a, best.b, std::sqrt(best.squared)};
}

double gap_along(const Vec3& n, const Corners& a, const Corners& b) {
  const double low = std::min({n.dot(a[0]), n.dot(a[1]), n.dot(a[2])});
  const double high = std::max({n.dot(b[0]), n.dot(b[1]), n.dot(b[2])});
  return low - high;
}

Separator separator(const ClosestPoints& closest, const Corners& a, const Corners& b) {
  Separator best{Vec3::UnitZ(), -std::numeric_limits<double>::infinity()};
  const auto offer = [&](const Vec3& axis) {
    const double length = axis.norm();
    if (!(length > 0)) return;
    const Vec3 n = axis / length;
    const double gap = gap_along(n, a, b), other = gap_along(-n, a, b);
    if (gap > best.gap) best = {n, gap};
    if (other > best.gap) best = {-n, other};
  };
  if (closest.distance > 0) {
    best.normal = (closest.a - closest.b) / closest.distance;
    best.gap = gap_along(best.normal, a, b);
    if (best.gap >= 0.999 * closest.distance) return best;
  }
  const Face face_a(a, b), face_b(b, a);
  offer(face_a.normal);
  offer(face_b.normal);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) offer(face_a.edge[i].cross(face_b.edge[j]));
    offer(face_a.edge[i].cross(face_a.normal));
    offer(face_b.edge[i].cross(face_b.normal));
  }
  return best;
}

Meeting classify(const Corners& a, const Corners& b) {
  // Working relative to a corner keeps the error small far from the origin: the differences round
  // once, to epsilon of the coordinates, which the margin covers.
  const double size = std::max(largest_coordinate(a), largest_coordinate(b));
  const double margin = 32 * epsilon * size;
  const auto apart_along = [&](const Vec3& axis) {
    const double length = axis.norm();
    if (!(length > 0)) return false;
    const Vec3 n = axis / length;
    return gap_along(n, a, b) > margin || gap_along(-n, a, b) > margin;
  };
  const Face face_a(a, b), face_b(b, a);
  if (apart_along(face_a.normal) || apart_along(face_b.normal)) return Meeting::apart;
  if (pierces(a, b) || pierces(b, a)) return Meeting::meeting;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (apart_along(face_a.edge[i].cross(face_b.edge[j]))) return Meeting::apart;
  for (std::size_t i = 0; i < 3; ++i)
    if (apart_along(face_a.edge[i].cross(face_a.normal)) ||
        apart_along(face_b.edge[i].cross(face_b.normal)))
      return Meeting::apart;
  const ClosestPoints closest = closest_points(a, b);
  return apart_along(closest.a - closest.b) ? Meeting::apart : Meeting::doubtful;
}

}  // namespace sonde
