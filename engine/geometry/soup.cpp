// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/soup.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/geometry/ear_clipping.hpp"

namespace sonde {
namespace {

using Vec2 = Eigen::Vector2d;

/// Newell's normal, relative to the first corner, which keeps it accurate far from the origin;
/// `unit` is the size of the polygon.
Vec3 newell_normal(const std::vector<Vec3>& points, const Polygon& polygon, double unit) {
  const Vec3 origin = points[polygon[0]];
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    normal +=
        ((points[polygon[i]] - origin) / unit).cross((points[polygon[i + 1]] - origin) / unit);
  return normal;
}

double polygon_size(const std::vector<Vec3>& points, const Polygon& polygon) {
  double size = 0;
  for (const std::size_t i : polygon)
    size = std::max(size, (points[i] - points[polygon[0]]).cwiseAbs().maxCoeff());
  return size;
}

/// The corners projected on the plane of the normal, counter-clockwise, of unit size.
std::vector<Vec2> flatten(const std::vector<Vec3>& points, const Polygon& polygon,
                          const Vec3& normal, double unit) {
  int smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  const Vec3 u = Vec3::Unit(smallest).cross(normal).normalized();
  const Vec3 v = normal.cross(u).normalized();
  std::vector<Vec2> flat;
  flat.reserve(polygon.size());
  for (const std::size_t i : polygon) {
    const Vec3 x = (points[i] - points[polygon[0]]) / unit;
    flat.emplace_back(u.dot(x), v.dot(x));
  }
  return flat;
}

Triangle triangle(std::size_t a, std::size_t b, std::size_t c) {
  return {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b),
          static_cast<std::uint32_t>(c)};
}

/// A quad is cut along the shorter of the diagonals that lie inside it.
void split_quad(const std::vector<Vec3>& points, const Polygon& q, const std::vector<Vec2>& flat,
                std::vector<Triangle>& out) {
  const auto fits = [&](std::size_t i) {  // both triangles of the diagonal from corner i
    return turn(flat[i], flat[i + 1], flat[i + 2]) > 0 &&
           turn(flat[i + 2], flat[(i + 3) % 4], flat[i]) > 0;
  };
  const bool second_is_shorter =
      (points[q[1]] - points[q[3]]).norm() < (points[q[0]] - points[q[2]]).norm();
  const bool use_second = flat.empty() ? false : fits(1) && (second_is_shorter || !fits(0));
  if (use_second) {
    out.push_back(triangle(q[0], q[1], q[3]));
    out.push_back(triangle(q[1], q[2], q[3]));
  } else {
    out.push_back(triangle(q[0], q[1], q[2]));
    out.push_back(triangle(q[0], q[2], q[3]));
  }
}

/// The polygon without corners that repeat the previous one.
const Polygon& without_repeats(const Polygon& polygon, Polygon& scratch) {
  bool repeats = polygon.size() > 1 && polygon.front() == polygon.back();
  for (std::size_t i = 1; i < polygon.size() && !repeats; ++i)
    repeats = polygon[i] == polygon[i - 1];
  if (!repeats) return polygon;
  scratch = polygon;
  scratch.erase(std::unique(scratch.begin(), scratch.end()), scratch.end());
  while (scratch.size() > 1 && scratch.front() == scratch.back()) scratch.pop_back();
  return scratch;
}

void triangulate_one(const std::vector<Vec3>& points, const Polygon& polygon,
                     std::vector<Triangle>& out) {
  if (polygon.empty()) return;
  if (polygon.size() < 3) {
    out.push_back(triangle(polygon.front(), polygon.back(), polygon.back()));
    return;
  }
  if (polygon.size() == 3) {
    out.push_back(triangle(polygon[0], polygon[1], polygon[2]));
    return;
  }
  const double unit = polygon_size(points, polygon);
  const Vec3 normal = unit > 0 ? newell_normal(points, polygon, unit) : Vec3::Zero();
  std::vector<Vec2> flat;
  if (normal.squaredNorm() > 0) flat = flatten(points, polygon, normal, unit);
  if (polygon.size() == 4) {
    split_quad(points, polygon, flat, out);
  } else if (flat.empty()) {  // no area: any triangulation that keeps the corners is valid
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      out.push_back(triangle(polygon[0], polygon[i], polygon[i + 1]));
  } else {
    clip_ears(polygon, std::move(flat), out);
  }
}

/// Quick test: true is certain, and needs no root or division. A sine of 1e-12 is far enough above
/// the 1e-15 of is_degenerate that rounding does not matter, and for these sizes fourth powers stay
/// in range.
bool has_clear_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, bc = c - b;
  const double longest = std::max({ab.squaredNorm(), bc.squaredNorm(), (a - c).squaredNorm()});
  return longest > 1e-60 && longest < 1e60 &&
         ab.cross(bc).squaredNorm() > 1e-24 * longest * longest;
}

}  // namespace

bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  if (has_clear_area(a, b, c)) return false;
  Vec3 edge[3] = {b - a, c - b, a - c};
  double unit = 0;  // in units of their own size, squared edges neither overflow nor underflow
  for (const Vec3& e : edge) unit = std::max(unit, e.cwiseAbs().maxCoeff());
  if (!(unit > 0)) return true;
  for (Vec3& e : edge) e /= unit;
  ordering::sort(edge, edge + 3,
                 [](const Vec3& x, const Vec3& y) { return x.squaredNorm() < y.squaredNorm(); });
  return edge[0].cross(edge[1]).norm() <= 1e-15 * edge[2].squaredNorm();
}

Soup triangulate_all(const PolygonSoup& polygons, const Progress& progress) {
  Soup soup;
  soup.vertices = polygons.points;
  soup.triangles.reserve(polygons.polygons.size());
  Polygon scratch;
  for_each_index(polygons.polygons.size(), progress, [&](std::size_t i) {
    triangulate_one(polygons.points, without_repeats(polygons.polygons[i], scratch),
                    soup.triangles);
  });
  return soup;
}

Triangulated triangulate(const PolygonSoup& polygons) {
  Triangulated out{triangulate_all(polygons), 0};
  const auto& x = out.soup.vertices;
  out.degenerate = std::erase_if(out.soup.triangles, [&](const Triangle& t) {
    return is_degenerate(x[t[0]], x[t[1]], x[t[2]]);
  });
  return out;
}

}  // namespace sonde
