// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/distance.hpp"

#include <utility>

#include "engine/proximity/inside.hpp"
#include "engine/proximity/placement.hpp"

namespace sonde {
namespace {

struct Search {
  const Placement& at;
  Distance best;

  void try_pair(std::uint32_t i, std::uint32_t j) {
    const ClosestPoints c = closest_points(at.corners_a(i), at.corners_b(j), best.distance);
    if (c.distance < best.distance) best = {c.distance, c.a, c.b, i, j, c.distance <= 0};
  }

  void try_leaves(const Tree::Node& na, const Tree::Node& nb) {
    for (std::uint32_t i = na.first; i < na.first + na.count; ++i)
      for (std::uint32_t j = nb.first; j < nb.first + nb.count; ++j) try_pair(i, j);
  }
};

double point_box_squared(const Tree::Node& n, const Vec3& x) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double out =
        std::abs(x[i] - static_cast<double>(n.center[i])) - static_cast<double>(n.half[i]);
    if (out > 0) sum += out * out;
  }
  return sum;
}

}  // namespace

Distance triangle_distance(const Body& a, const Body& b, const Transform& X_BA,
                           std::optional<DistanceHint> hint) {
  const Placement at(a, b, X_BA);
  Search search{at, {}};
  search.best.distance = std::numeric_limits<double>::infinity();
  const DistanceHint start = hint.value_or(DistanceHint{});
  search.try_pair(start.triangle_a < a.soup.triangles.size() ? start.triangle_a : 0,
                  start.triangle_b < b.soup.triangles.size() ? start.triangle_b : 0);
  struct Entry {
    std::uint32_t a, b;
    double bound;
  };
  PairStack<Entry> stack;
  stack.push({0, 0, at.box_distance(a.tree.nodes[0], b.tree.nodes[0])});
  while (!stack.empty() && search.best.distance > 0) {
    const Entry e = stack.pop();
    if (e.bound >= search.best.distance) continue;
    const Tree::Node& na = a.tree.nodes[e.a];
    const Tree::Node& nb = b.tree.nodes[e.b];
    if (na.is_leaf() && nb.is_leaf()) {
      search.try_leaves(na, nb);
      continue;
    }
    Entry c0, c1;
    if (open_first(na, nb))
      c0 = {na.first, e.b, 0}, c1 = {na.first + 1, e.b, 0};
    else
      c0 = {e.a, nb.first, 0}, c1 = {e.a, nb.first + 1, 0};
    c0.bound = at.box_distance(a.tree.nodes[c0.a], b.tree.nodes[c0.b]);
    c1.bound = at.box_distance(a.tree.nodes[c1.a], b.tree.nodes[c1.b]);
    if (c1.bound < c0.bound) std::swap(c0, c1);
    if (c1.bound < search.best.distance) stack.push(c1);
    if (c0.bound < search.best.distance) stack.push(c0);
  }
  return search.best;
}

Distance distance(const Body& a, const Body& b, const Transform& X_BA,
                  std::optional<DistanceHint> hint) {
  Distance d = triangle_distance(a, b, X_BA, hint);
  if (!d.overlapping && component_inside(a, b, X_BA)) d.overlapping = true, d.distance = 0;
  return d;
}

double point_distance(const Body& body, const Vec3& x, double enough) {
  double best = std::numeric_limits<double>::infinity();
  struct Entry {
    std::uint32_t node;
    double bound;
  };
  PairStack<Entry> stack;
  stack.push({0, 0});
  while (!stack.empty()) {
    const Entry e = stack.pop();
    if (e.bound >= best) continue;
    const Tree::Node& n = body.tree.nodes[e.node];
    if (n.is_leaf()) {
      for (std::uint32_t i = n.first; i < n.first + n.count; ++i) {
        const double d = closest_points({x, x, x}, corners(body.soup, i)).distance;
        best = std::min(best, d * d);
      }
      if (best < enough * enough) break;
      continue;
    }
    Entry c0{n.first, point_box_squared(body.tree.nodes[n.first], x)};
    Entry c1{n.first + 1, point_box_squared(body.tree.nodes[n.first + 1], x)};
    if (c1.bound < c0.bound) std::swap(c0, c1);
    stack.push(c1);
    stack.push(c0);
  }
  return std::sqrt(best);
}

}  // namespace sonde
