// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/triangles/triangle_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sonde {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Face {
  std::array<Vec3, 3> edge;  // edge i runs from corner i to corner i + 1
  Vec3 normal;
  explicit Face(const Corners& t) {
    for (std::size_t i = 0; i < 3; ++i) edge[i] = t[(i + 1) % 3] - t[i];
    normal = edge[0].cross(edge[1]);
  }
};

double largest_coordinate(const Corners& t) {
  double m = 0;
  for (const Vec3& x : t) m = std::max(m, x.cwiseAbs().maxCoeff());
  return m;
}

/// Sign of a determinant with an error bound: 0 if undecided.
int sign(double value, double error) { return value > error ? 1 : (value < -error ? -1 : 0); }

/// orient3d(a, b, c, d) in double with a forward error bound: products of three differences, each
/// difference accurate to epsilon; 1e-15 of the permanent bounds the total error (Shewchuk 1997 has
/// 7.8e-16 for the determinant of rounded differences).
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

/// Whether an edge of `other` certainly pierces `face`.
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

double gap_along(const Vec3& n, const Corners& a, const Corners& b) {
  const double low = std::min({n.dot(a[0]), n.dot(a[1]), n.dot(a[2])});
  const double high = std::max({n.dot(b[0]), n.dot(b[1]), n.dot(b[2])});
  return low - high;
}

Meeting classify(const Corners& a, const Corners& b) {
  // The determinants are relative to a corner, which keeps the error small far from the origin: the
  // differences round once, to epsilon of the coordinates, which the margin covers.
  const double size = std::max(largest_coordinate(a), largest_coordinate(b));
  const double margin = 32 * epsilon * size;
  const auto apart_along = [&](const Vec3& axis) {
    const double length = axis.norm();
    if (!(length > 0)) return false;
    const Vec3 n = axis / length;
    return gap_along(n, a, b) > margin || gap_along(-n, a, b) > margin;
  };
  const Face face_a(a), face_b(b);
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
  return apart_along(closest.normal) ? Meeting::apart : Meeting::doubtful;
}

}  // namespace sonde
