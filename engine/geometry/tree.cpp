// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace sonde {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int max_depth = 60;
constexpr int bins = 16;

struct Box {
  Vec3 low = Vec3::Constant(infinity);
  Vec3 high = Vec3::Constant(-infinity);
  void add(const Vec3& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  void add(const Box& o) {
    low = low.cwiseMin(o.low);
    high = high.cwiseMax(o.high);
  }
  bool empty() const { return low.x() > high.x(); }
  Vec3 size() const { return high - low; }
  double half_area() const {
    if (empty()) return 0;
    const Vec3 s = size();
    return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
  }
};

struct Item {
  Box box;
  Vec3 middle() const { return box.low + box.high; }  ///< twice the box's middle
  std::uint32_t triangle;
};

using Range = std::span<Item>;

/// A function that is not inlined, because g++ 12 at -O2 takes pairs of double → float → double for
/// doing nothing (its vectorizer drops the rounding), and the check of the box would pass unseen.
[[gnu::noinline]] float to_float(double x) { return static_cast<float>(x); }

/// The box in single precision, rounded outwards: [center - half, center + half], evaluated in
/// double precision, holds it.
void store(const Box& box, Tree::Node& node) {
  for (int k = 0; k < 3; ++k) {
    const double low = box.low[k], high = box.high[k];
    const float center = to_float(low + (high - low) / 2);
    float half = to_float(std::max(high - center, center - low));
    while (!(double{center} - double{half} <= low && high <= double{center} + double{half}))
      half = std::nextafter(half, std::numeric_limits<float>::infinity());
    node.center[k] = center;
    node.half[k] = half;
  }
}

struct Split {
  double cost = infinity;
  int axis = 0;
  int bin = 0;  ///< the last of the left side
};

/// Maps middles to bins along one axis.
struct Bins {
  double low, per_length;
  int operator()(double x) const {
    return std::clamp(static_cast<int>((x - low) * per_length), 0, bins - 1);
  }
};

Bins bins_along(const Box& middles, int axis) {
  return {middles.low[axis], bins / (middles.high[axis] - middles.low[axis])};
}

/// The cheapest split along one axis by the surface-area heuristic.
void try_axis(Range items, const Box& middles, int axis, Split& best) {
  const Bins bin_of = bins_along(middles, axis);
  if (!std::isfinite(bin_of.per_length)) return;  // all middles in one plane across the axis
  Box box[bins];
  std::size_t count[bins] = {};
  for (const Item& item : items) {
    const int b = bin_of(item.middle()[axis]);
    box[b].add(item.box);
    ++count[b];
  }
  double right_cost[bins];
  Box side;
  std::size_t n = 0;
  for (int b = bins - 1; b > 0; --b) {
    side.add(box[b]);
    n += count[b];
    right_cost[b] = side.half_area() * static_cast<double>(n);
  }
  side = Box();
  n = 0;
  for (int b = 0; b + 1 < bins; ++b) {
    side.add(box[b]);
    n += count[b];
    if (n == 0 || n == items.size()) continue;
    const double cost = side.half_area() * static_cast<double>(n) + right_cost[b + 1];
    if (cost < best.cost) best = {cost, axis, b};
  }
}

/// Halves by count along the longest axis; ties go by the triangle's number.
std::size_t split_in_half(Range items, const Box& middles) {
  int axis = 0;
  middles.size().maxCoeff(&axis);
  const auto half = items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2);
  std::nth_element(items.begin(), half, items.end(), [axis](const Item& a, const Item& b) {
    const double x = a.middle()[axis], y = b.middle()[axis];
    return x != y ? x < y : a.triangle < b.triangle;
  });
  return items.size() / 2;
}

/// Reorders the items and returns how many go to the left: at least one, not all.
std::size_t split(Range items, int level) {
  Box middles;
  for (const Item& item : items) middles.add(item.middle());
  // Halving from here on still ends in time; an uneven split might not.
  const bool must_halve = level + std::bit_width(items.size()) >= max_depth;
  Split best;
  if (!must_halve && items.size() > 4)
    for (int axis = 0; axis < 3; ++axis) try_axis(items, middles, axis, best);
  if (!(best.cost > 0 && best.cost < infinity)) return split_in_half(items, middles);
  const Bins bin_of = bins_along(middles, best.axis);
  const auto right = std::partition(items.begin(), items.end(), [&](const Item& item) {
    return bin_of(item.middle()[best.axis]) <= best.bin;
  });
  return static_cast<std::size_t>(right - items.begin());
}

std::vector<Item> items_of(const Soup& soup) {
  std::vector<Item> items(soup.triangles.size());
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    items[i].triangle = i;
    for (const std::uint32_t v : soup.triangles[i]) items[i].box.add(soup.vertices[v]);
  }
  return items;
}

struct Task {
  std::uint32_t node, first, count;
  int level;
};

void build_nodes(std::vector<Item>& items, Tree& tree) {
  tree.nodes.reserve(items.size() + 1);
  tree.nodes.emplace_back();
  std::vector<Task> tasks{{0, 0, static_cast<std::uint32_t>(items.size()), 0}};
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    const Range range(items.data() + task.first, task.count);
    Box box;
    for (const Item& item : range) box.add(item.box);
    Tree::Node node;
    store(box, node);
    tree.depth = std::max(tree.depth, task.level);
    if (task.count <= Tree::leaf_size) {
      node.first = task.first;
      node.count = task.count;
    } else {
      const auto left = static_cast<std::uint32_t>(split(range, task.level));
      node.first = static_cast<std::uint32_t>(tree.nodes.size());
      node.count = 0;
      tree.nodes.resize(tree.nodes.size() + 2);
      tasks.push_back({node.first + 1, task.first + left, task.count - left, task.level + 1});
      tasks.push_back({node.first, task.first, left, task.level + 1});
    }
    tree.nodes[task.node] = node;
  }
}

}  // namespace

Tree build_tree(Soup& soup, std::vector<std::uint32_t>& order) {
  Tree tree;
  order.clear();
  if (soup.triangles.empty()) return tree;
  std::vector<Item> items = items_of(soup);
  build_nodes(items, tree);
  const std::vector<Triangle> old = soup.triangles;
  order.reserve(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    order.push_back(items[i].triangle);
    soup.triangles[i] = old[items[i].triangle];
  }
  return tree;
}

}  // namespace sonde
