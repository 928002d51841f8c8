// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/ray_hit.hpp"

namespace sonde {
namespace {

/// Möller and Trumbore's: how far along the ray the triangle is; none where it is missed.
std::optional<double> distance_to(const Vec3& from, const Vec3& direction, const Vec3& a,
                                  const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, across = direction.cross(ac);
  const double volume = ab.dot(across);
  if (volume == 0) return {};
  const Vec3 from_a = from - a;
  const double u = from_a.dot(across) / volume;
  if (!(u >= 0 && u <= 1)) return {};
  const Vec3 other = from_a.cross(ab);
  const double v = direction.dot(other) / volume;
  if (!(v >= 0 && u + v <= 1)) return {};
  const double distance = ac.dot(other) / volume;
  if (!(distance >= 0)) return {};
  return distance;
}

}  // namespace

std::optional<RayHit> ray_hit(const Soup& soup, const Vec3& from, const Vec3& direction,
                              const std::function<bool(const Vec3&)>& counts) {
  std::optional<RayHit> nearest;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    const auto distance =
        distance_to(from, direction, soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]);
    if (!distance || (nearest && *distance >= nearest->distance)) continue;
    if (counts && !counts(from + *distance * direction)) continue;
    nearest = RayHit{*distance, static_cast<std::uint32_t>(i)};
  }
  return nearest;
}

}  // namespace sonde
