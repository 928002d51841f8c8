// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/queries/point_distance.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/base/ordering.hpp"
#include "engine/geometry/to_float.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

/// The point of a triangle nearest to x, by the regions of its corners, edges and face (Ericson,
/// Real-Time Collision Detection, 5.1.5), with x as the origin. For needles it may not be the
/// nearest.
Vec3 nearest_by_regions(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = -ab.dot(a), d2 = -ac.dot(a), d3 = -ab.dot(b), d4 = -ac.dot(b), d5 = -ab.dot(c),
               d6 = -ac.dot(c);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * Vec3(c - b);
  return a + (vb * ab + vc * ac) / (va + vb + vc);
}

/// The nearest point of one triangle. If a corner is nearer along the direction found, by more than
/// rounding, the point is wrong, and the robust method computes it again.
NearestPoint nearest_of(const Corners& t, const Vec3& x) {
  const Vec3 a = t[0] - x, b = t[1] - x, c = t[2] - x;
  const Vec3 p = nearest_by_regions(a, b, c);
  const double squared = p.squaredNorm(), distance = std::sqrt(squared);
  const double rounding =
      1e-15 * distance * std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}));
  if (std::min({p.dot(a), p.dot(b), p.dot(c)}) >= squared - rounding) return {distance, x + p};
  const ClosestPoints closest = closest_points({x, x, x}, t);
  return {closest.distance, closest.b};
}

/// The fast method always returns a point of the triangle, even of a needle, so it overestimates.
bool comes_within(const Corners& t, const Vec3& x, double radius) {
  const double found = nearest_by_regions(t[0] - x, t[1] - x, t[2] - x).norm();
  return found <= radius || (found <= 8 * radius && nearest_of(t, x).distance <= radius);
}

}  // namespace

PointFrame::PointFrame(const Body& body, const Vec3& x) {
  const Tree& tree = body.tree;
  const Vec3 local = x - tree.origin;
  const double size = (tree.high - tree.low).maxCoeff() + local.cwiseAbs().maxCoeff();
  per_unit = std::ldexp(1.0, -std::ilogb(size));
  scale = static_cast<float>(per_unit);
  for (int i = 0; i < 3; ++i) {
    point.origin[i] = to_float(local[i] * per_unit);
    point.rest[i] = static_cast<float>(local[i] * per_unit - static_cast<double>(point.origin[i]));
  }
  guard = static_cast<float>(rounding_guard(extent(body), 0, x) * per_unit) * (1 + 0x1p-22f) +
          underflow_guard;
}

double point_distance(const Body& body, const Vec3& x, double enough) {
  return nearest_point(body, x, enough).distance;
}

NearestPoint nearest_point(const Body& body, const Vec3& x, double enough) {
  const PointFrame frame(body, x);
  const BoxKernels& kernels = box_kernels();
  NearestPoint best{std::numeric_limits<double>::infinity(), x};
  float limit = std::numeric_limits<float>::infinity();
  struct Entry {
    std::uint32_t child;
    float bound;
  };
  PairStack<Entry> stack;
  stack.push({body.tree.child(0), 0});
  while (!stack.empty()) {
    const Entry e = stack.pop();
    if (e.bound > limit) continue;
    if (e.child & Tree::triangle_bit) {
      const Corners t = corners(surface(body), e.child & ~Tree::triangle_bit);
      const NearestPoint found = nearest_of(t, x);
      if (found.distance < best.distance)
        best = {found.distance, found.point, e.child & ~Tree::triangle_bit};
      if (best.distance < enough) break;
      limit = static_cast<float>(best.distance * frame.per_unit) * (1 + 0x1p-22f);
      continue;
    }
    const Tree::Node& node = body.tree.nodes[e.child];
    Lanes bounds;
    kernels.point_distances(frame.point, node, frame.scale, bounds);
    std::uint32_t left = at_most(bounds, limit + frame.guard, node);
    std::array<Entry, Tree::width> found;
    std::size_t count = 0;
    for (; left != 0; left &= left - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      found[count++] = {node.child[k], bounds.value[k] - frame.guard};
    }
    ordering::sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count),
                   [](const Entry& p, const Entry& q) { return p.bound > q.bound; });
    for (std::size_t k = 0; k < count; ++k) stack.push(found[k]);
  }
  return best;
}

std::size_t triangles_within(const Body& body, const Vec3& x, double radius,
                             std::span<std::uint32_t> out) {
  const PointFrame frame(body, x);
  const BoxKernels& kernels = box_kernels();
  const float limit = static_cast<float>(radius * frame.per_unit) * (1 + 0x1p-22f) + frame.guard;
  PairStack<std::uint32_t> stack;
  stack.push(body.tree.child(0));
  std::size_t count = 0;
  while (!stack.empty() && count < out.size()) {
    const std::uint32_t child = stack.pop();
    if (child & Tree::triangle_bit) {
      const std::uint32_t triangle = child & ~Tree::triangle_bit;
      if (comes_within(corners(surface(body), triangle), x, radius)) out[count++] = triangle;
      continue;
    }
    const Tree::Node& node = body.tree.nodes[child];
    Lanes bounds;
    kernels.point_distances(frame.point, node, frame.scale, bounds);
    for (std::uint32_t left = at_most(bounds, limit, node); left != 0; left &= left - 1)
      stack.push(node.child[std::countr_zero(left)]);
  }
  return count;
}

}  // namespace sonde
