// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/inside.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/base/elementary.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/point_distance.hpp"

namespace sonde {
namespace {

/// Directions in general position: no axis, no diagonal. The third component is never the smallest.
constexpr double rays[][3] = {{0.2113, 0.3719, 0.9039},  {-0.4127, 0.2371, 0.8795},
                              {0.3317, -0.5923, 0.7343}, {-0.1931, -0.4409, -0.8765},
                              {0.6113, 0.1297, -0.7807}, {-0.5479, 0.6151, -0.5669}};

/// Signed crossing of a ray with a triangle: ±1 or 0; no value if it is too near an edge to decide.
std::optional<int> crossing(const Vec3& x, const Vec3& d, const Corners& t) {
  const Vec3 p = t[0] - x, q = t[1] - x, r = t[2] - x;
  const double scale = d.norm();
  const auto volume = [&](const Vec3& a, const Vec3& b) {
    const double v = d.dot(a.cross(b));
    const double error = 1e-14 * scale * a.norm() * b.norm();
    return std::abs(v) <= error ? 0 : (v > 0 ? 1 : -1);
  };
  const int s0 = volume(p, q), s1 = volume(q, r), s2 = volume(r, p);
  if (s0 * s1 < 0 || s1 * s2 < 0 || s2 * s0 < 0) return 0;
  // The triangle's plane is in front if its height along the ray is positive.
  const Vec3 n = area_normal(t);
  const double facing = n.dot(d), height = n.dot(p);
  if (s0 == 0 || s1 == 0 || s2 == 0) {
    const bool behind = p.dot(d) < 0 && q.dot(d) < 0 && r.dot(d) < 0;
    if (behind) return 0;
    return std::nullopt;
  }
  if (std::abs(height) <= 1e-14 * n.norm() * p.norm()) return std::nullopt;
  if ((height > 0) != (facing > 0)) return 0;
  return s0;
}

std::optional<int> count_along(const Body& body, const Vec3& x, const Vec3& d) {
  const PointFrame frame(body, x);
  const Vec3 unit = d.normalized();
  PlacedRay ray{frame.point, {}};
  for (int i = 0; i < 3; ++i) ray.direction[i] = static_cast<float>(unit[i]);
  const BoxKernels& kernels = box_kernels();
  PairStack<std::uint32_t> stack;
  stack.push(body.tree.child(0));
  int winding = 0;
  while (!stack.empty()) {
    const std::uint32_t child = stack.pop();
    if (child & Tree::triangle_bit) {
      const std::uint32_t triangle = child & ~Tree::triangle_bit;
      if (is_loose(body, triangle)) continue;
      const auto c = crossing(x, d, corners(surface(body), triangle));
      if (!c) return std::nullopt;
      winding += *c;
      continue;
    }
    const Tree::Node& node = body.tree.nodes[child];
    Lanes gaps;
    kernels.ray_gaps(ray, node, frame.scale, gaps);
    std::uint32_t left = at_most(gaps, frame.guard, node);
    for (; left != 0; left &= left - 1)
      stack.push(node.child[static_cast<std::size_t>(std::countr_zero(left))]);
  }
  return winding;
}

/// The winding number counted along the ray d; no value if the ray passes too near an edge. A ray
/// may slip through a crack; then the opposite ray gives another number, and there is no value.
std::optional<int> winding_along(const Body& body, const Vec3& x, const Vec3& d) {
  const std::optional<int> winding = count_along(body, x, d);
  if (winding && body.cracked && count_along(body, x, -d) != winding) return std::nullopt;
  return winding;
}

/// Sum of signed solid angles over 4π (Van Oosterom and Strackee, 1983), rounded.
int winding_by_solid_angles(const Body& body, const Vec3& x) {
  double sum = 0;
  for (std::uint32_t i = 0; i < surface(body).triangles.size(); ++i) {
    if (is_loose(body, i)) continue;
    const Corners t = corners(surface(body), i);
    const Vec3 a = t[0] - x, b = t[1] - x, c = t[2] - x;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += elementary::atan2(a.dot(b.cross(c)),
                             la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
}

/// A corner of a triangle of `body`, in the frame of the solid. X takes body to solid.
Vec3 corner(const Body& body, std::uint32_t triangle, const Transform& X) {
  return X * surface(body).vertices[surface(body).triangles[triangle][0]];
}

/// Up to this many components are quicker to test one by one.
constexpr std::size_t few_components = 1024;

/// The same for bodies of many components, given that no triangles meet: a box that is clear of the
/// solid's surface is inside or outside as a whole, so one point decides for it. Any triangle
/// decides for its component.
bool any_triangle_inside(const Body& body, const Body& solid, const Transform& X) {
  PairStack<std::uint32_t> stack;
  stack.push(0);
  while (!stack.empty()) {
    const std::uint32_t slot = stack.pop();
    const std::uint32_t child = body.tree.child(slot);
    if (child & Tree::triangle_bit) {
      if (winds_around(solid, corner(body, child & ~Tree::triangle_bit, X))) return true;
      continue;
    }
    const Vec3 center = X * body.tree.center(slot);
    const double radius = body.tree.half_diagonal(slot) * (1 + 1e-6);
    const Vec3 in_box = center.cwiseMax(solid.tree.low).cwiseMin(solid.tree.high);
    const double to_box = (center - in_box).norm();
    const double guard = rounding_guard(extent(body), extent(solid), X.p);
    if (to_box > radius + guard) continue;
    // Testing a few triangles is quicker than computing the distance of their box.
    const Tree::Node& node = body.tree.nodes[child];
    const bool many = (node.child[0] & Tree::triangle_bit) == 0;
    if (many && point_distance(solid, center, radius + guard) > radius + guard) {
      if (winds_around(solid, center)) return true;
      continue;
    }
    for (std::uint32_t k = 0; k < Tree::width; ++k)
      if (node.child[k] != Tree::none) stack.push(child * Tree::width + k);
  }
  return false;
}

/// Whether a component of `body` lies inside `solid`. One corner of each component decides.
bool any_component_inside(const Body& body, const Body& solid, const Transform& X) {
  if (body.component_triangle.size() > few_components) return any_triangle_inside(body, solid, X);
  return std::ranges::any_of(body.component_triangle, [&](std::uint32_t triangle) {
    return winds_around(solid, corner(body, triangle, X));
  });
}

}  // namespace

int winding_number(const Body& body, const Vec3& x) {
  for (const auto& ray : rays)
    if (const auto w = winding_along(body, x, Vec3(ray[0], ray[1], ray[2]))) return *w;
  return winding_by_solid_angles(body, x);
}

bool winds_around(const Body& solid, const Vec3& x) {
  const Tree& tree = solid.tree;
  for (int i = 0; i < 3; ++i)
    if (x[i] < tree.low[i] || x[i] > tree.high[i]) return false;
  return winding_number(solid, x) != 0;
}

bool component_inside(const Body& a, const Body& b, const Transform& X_BA) {
  if (b.solid && any_component_inside(a, b, X_BA)) return true;
  if (!a.solid) return false;
  const Transform X_AB(X_BA.R.transpose(), -(X_BA.R.transpose() * X_BA.p));
  return any_component_inside(b, a, X_AB);
}

}  // namespace sonde
