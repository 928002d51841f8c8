// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/point_distance.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "engine/geometry/to_float.hpp"
#include "engine/proximity/placement.hpp"

namespace sonde {

PointFrame::PointFrame(const Body& body, const Vec3& x) {
  const Tree& tree = body.tree;
  const Vec3 local = x - tree.origin;
  const double size = (tree.high - tree.low).maxCoeff() + local.cwiseAbs().maxCoeff();
  per_unit = std::exp2(-std::ilogb(size));
  scale = static_cast<float>(per_unit);
  for (int i = 0; i < 3; ++i) {
    point.origin[i] = to_float(local[i] * per_unit);
    point.rest[i] = static_cast<float>(local[i] * per_unit - static_cast<double>(point.origin[i]));
  }
  guard = static_cast<float>(rounding_guard(extent(body), 0, x) * per_unit) * (1 + 0x1p-22f) +
          underflow_guard;
}

double point_distance(const Body& body, const Vec3& x, double enough) {
  const PointFrame frame(body, x);
  const BoxKernels& kernels = box_kernels();
  double best = std::numeric_limits<double>::infinity();
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
      const Corners t = corners(body.soup, e.child & ~Tree::triangle_bit);
      best = std::min(best, closest_points({x, x, x}, t).distance);
      if (best < enough) break;
      limit = static_cast<float>(best * frame.per_unit) * (1 + 0x1p-22f);
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
    std::sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Entry& p, const Entry& q) { return p.bound > q.bound; });
    for (std::size_t k = 0; k < count; ++k) stack.push(found[k]);
  }
  return best;
}

}  // namespace sonde
