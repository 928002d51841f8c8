// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/ray_hit.hpp"

#include <bit>
#include <utility>

#include "engine/proximity/queries/covered.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {
namespace {

/// Permutes and shears the axes so that the ray runs along the third one. For an edge that two
/// triangles share, both then compute the same number with opposite sign, so that no ray slips
/// through between them (Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, 2013).
struct Sheared {
  Vec3 from;
  Eigen::Index x, y, z;
  double shear_x, shear_y, per_z;

  Sheared(const Vec3& origin, const Vec3& direction) : from(origin) {
    direction.cwiseAbs().maxCoeff(&z);
    x = (z + 1) % 3, y = (z + 2) % 3;
    if (direction[z] < 0) std::swap(x, y);
    shear_x = direction[x] / direction[z];
    shear_y = direction[y] / direction[z];
    per_z = 1 / direction[z];
  }
  Vec3 operator()(const Vec3& point) const {
    const Vec3 p = point - from;
    return {p[x] - shear_x * p[z], p[y] - shear_y * p[z], per_z * p[z]};
  }
};

/// Distance along the ray to the triangle; no value if the ray misses it, or lies in its plane.
std::optional<double> distance_to(const Sheared& ray, const Corners& t) {
  const Vec3 a = ray(t[0]), b = ray(t[1]), c = ray(t[2]);
  const auto across = [](const Vec3& p, const Vec3& q) { return p.x() * q.y() - p.y() * q.x(); };
  const double u = across(c, b), v = across(a, c), w = across(b, a);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
  const double volume = u + v + w;
  if (volume == 0) return {};
  const double distance = (u * a.z() + v * b.z() + w * c.z()) / volume;
  if (!(distance >= 0)) return {};
  return distance;
}

}  // namespace

std::optional<RayHit> ray_hit(const Soup& soup, const Vec3& from, const Vec3& direction,
                              const std::function<bool(const Vec3&)>& counts) {
  const Sheared ray(from, direction);
  std::optional<RayHit> nearest;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const auto distance = distance_to(ray, corners(soup, static_cast<std::uint32_t>(i)));
    if (!distance || (nearest && *distance >= nearest->distance)) continue;
    if (counts && !counts(from + *distance * direction)) continue;
    nearest = RayHit{*distance, static_cast<std::uint32_t>(i)};
  }
  return nearest;
}

std::optional<RayHit> first_hit(const Body& body, const Vec3& from, const Vec3& direction) {
  const PointFrame frame(body, from);
  PlacedRay boxed{frame.point, {}};
  for (int i = 0; i < 3; ++i) boxed.direction[i] = static_cast<float>(direction[i]);
  const BoxKernels& kernels = box_kernels();
  const Soup& soup = surface(body);
  const Sheared ray(from, direction);
  PairStack<std::uint32_t> stack;  // slots
  stack.push(0);
  std::optional<RayHit> nearest;
  while (!stack.empty()) {
    const std::uint32_t slot = stack.pop(), child = body.tree.child(slot);
    if (child & Tree::triangle_bit) {
      const std::uint32_t triangle = child & ~Tree::triangle_bit;
      const auto distance = distance_to(ray, corners(soup, triangle));
      if (!distance || (nearest && *distance >= nearest->distance)) continue;
      if (is_covered(body, triangle, from + *distance * direction)) continue;
      nearest = RayHit{*distance, triangle};
      continue;
    }
    // Skips a box that lies entirely behind the nearest hit.
    const double middle = direction.dot(body.tree.center(slot) - from);
    const double before = middle - body.tree.half_diagonal(slot) * (1 + 1e-6);
    if (nearest && before > nearest->distance) continue;
    const Tree::Node& node = body.tree.nodes[child];
    Lanes gaps;
    kernels.ray_gaps(boxed, node, frame.scale, gaps);
    for (std::uint32_t left = at_most(gaps, frame.guard, node); left != 0; left &= left - 1)
      stack.push(child * Tree::width + static_cast<std::uint32_t>(std::countr_zero(left)));
  }
  return nearest;
}

}  // namespace sonde
