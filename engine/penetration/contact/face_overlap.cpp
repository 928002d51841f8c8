// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/face_overlap.hpp"

#include <cmath>

#include "engine/penetration/contact/contact_tuning.hpp"

namespace sonde {
namespace {

struct ConvexPolygon {
  std::array<Vec3, 9> points;
  std::size_t size = 0;
  void push(const Vec3& x) {
    if (size < points.size()) points[size++] = x;
  }
};

/// The part of a polygon on the side of x·side ≥ bound (Sutherland and Hodgman, 1974).
ConvexPolygon clip(const ConvexPolygon& in, const Vec3& side, double bound) {
  ConvexPolygon out;
  for (std::size_t i = 0; i < in.size; ++i) {
    const Vec3& p = in.points[i];
    const Vec3& q = in.points[(i + 1) % in.size];
    const double hp = side.dot(p) - bound, hq = side.dot(q) - bound;
    if (hp >= 0) out.push(p);
    if ((hp >= 0) != (hq >= 0)) out.push(p + hp / (hp - hq) * (q - p));
  }
  return out;
}

}  // namespace

FaceOverlap face_overlap(const Corners& a, const Corners& b, const Vec3& normal) {
  FaceOverlap out;
  const Vec3 face = (b[1] - b[0]).cross(b[2] - b[0]);
  const double facing = face.dot(normal);
  if (std::abs(facing) <= contact_tuning.edge_on * face.norm()) return out;
  ConvexPolygon polygon;
  for (const Vec3& x : a) polygon.push(x);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 inward = (facing > 0 ? 1.0 : -1.0) * normal.cross(b[(i + 1) % 3] - b[i]);
    polygon = clip(polygon, inward, inward.dot(b[i]));
  }
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec3& p = polygon.points[i];
    const double gap = face.dot(p - b[0]) / facing;
    out.corners[static_cast<std::size_t>(out.size++)] = {p, p - gap * normal, normal, gap, 0};
  }
  return out;
}

}  // namespace sonde
