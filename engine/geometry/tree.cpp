// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/tree.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <span>

#include "engine/geometry/oriented_box.hpp"
#include "engine/geometry/split.hpp"

namespace sonde {
namespace {

constexpr std::size_t width = Tree::width;
using Items = std::span<SplitItem>;

/// How far the build has come; one thread tells, all of them stop where the answer was no.
struct Advance {
  const Progress& tell;
  std::size_t total;
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> cancelled = false;
  void report() {
    const double fraction = static_cast<double>(done.load()) / static_cast<double>(total);
    if (tell && !tell(std::min(1.0, fraction))) cancelled = true;
  }
};

/// What all of the build reads.
struct Job {
  const Soup& soup;
  Vec3 origin;
  double slack;  // the rounding of a corner's coordinates and of their difference to the origin, m
  Items all;
  Advance& advance;

  std::array<Vec3, 3> corners(const SplitItem& item) const {
    const Triangle& t = soup.triangles[item.triangle];
    return {soup.vertices[t[0]] - origin, soup.vertices[t[1]] - origin,
            soup.vertices[t[2]] - origin};
  }
};

/// Least number of nodes from one over n items down to the last.
int levels_below(std::size_t n) {
  int levels = 1;
  for (; n > width; n = (n + width - 1) / width) ++levels;
  return levels;
}

/// Up to sixteen parts of a range, in its order.
struct Parts {
  std::array<Items, width> part;
  std::size_t count = 0;
};

Parts divide(Items items, int level) {
  Parts parts;
  if (items.size() <= width) {
    for (; parts.count < items.size(); ++parts.count)
      parts.part[parts.count] = items.subspan(parts.count, 1);
    return parts;
  }
  // Halving from here on still ends in time; an uneven split might not.
  const bool halve = level + levels_below(items.size()) + 2 >= Tree::max_depth;
  std::array<double, width> weight{};
  parts.part[parts.count++] = items;
  const auto weigh = [halve](Items part) {
    if (part.size() <= width) return -1.0;
    const auto n = static_cast<double>(part.size());
    return halve ? n : n * half_area(part);
  };
  weight[0] = weigh(items);
  while (parts.count < width) {
    const auto heaviest = static_cast<std::size_t>(
        std::max_element(weight.begin(), weight.begin() + parts.count) - weight.begin());
    if (weight[heaviest] < 0) break;
    const Items part = parts.part[heaviest];
    const std::size_t left = split(part, halve ? SplitBy::half : SplitBy::cost, width);
    for (std::size_t k = parts.count; k > heaviest + 1; --k)
      parts.part[k] = parts.part[k - 1], weight[k] = weight[k - 1];
    parts.part[heaviest] = part.first(left);
    parts.part[heaviest + 1] = part.subspan(left);
    for (const std::size_t k : {heaviest, heaviest + 1}) weight[k] = weigh(parts.part[k]);
    ++parts.count;
  }
  return parts;
}

Extent extent_along(const Job& job, Items items, const SmallAxes& axes) {
  Extent extent(axes_of(axes));
  for (const SplitItem& item : items)
    for (const Vec3& x : job.corners(item)) extent.add(x);
  return extent;
}

/// What a box costs: its volume, with a hundredth of its longest side added to each, so that of two
/// flat ones the smaller is the better. Not its surface, for which a thick box over a small part of
/// a surface may be as good as a thin one: two surfaces beside each other are told apart by the
/// thickness of the boxes.
double cost(const Extent& e) {
  const Vec3 size = e.high - e.low;
  const Vec3 padded = size / size.maxCoeff() + Vec3::Constant(0.01);
  return padded.prod() * std::pow(size.maxCoeff(), 3);
}

void set_box(Tree::Node& node, std::size_t lane, const SmallAxes& axes, const SmallBox& box,
             std::uint32_t child) {
  for (std::size_t i = 0; i < 3; ++i) {
    node.center[i][lane] = box.center[i];
    node.half[i][lane] = box.half[i];
    for (std::size_t k = 0; k < 2; ++k) node.axis[k][i][lane] = axes[k][i];
  }
  node.child[lane] = child;
}

/// The smaller of the boxes along the principal axes and along those of the mesh frame.
void fit_box(const Job& job, Items items, const Mat3& axes, Tree::Node& node, std::size_t lane,
             std::uint32_t child) {
  const SmallAxes turned_axes = small_axes(axes), straight = small_axes(Mat3::Identity());
  const Extent turned = extent_along(job, items, turned_axes);
  if (items.size() > 1) {
    const Extent along = extent_along(job, items, straight);
    if (cost(along) < cost(turned)) {
      set_box(node, lane, straight, small_box(along, job.slack), child);
      return;
    }
  }
  set_box(node, lane, turned_axes, small_box(turned, job.slack), child);
}

void fill_unused(Tree::Node& node, std::size_t used) {
  for (std::size_t k = used; k < width; ++k) {
    for (auto& row : node.center) row[k] = row[0];
    for (auto& row : node.half) row[k] = row[0];
    for (auto& axis : node.axis)
      for (auto& row : axis) row[k] = row[0];
    node.child[k] = Tree::none;
  }
}

/// A part of the tree: its nodes, numbered from 0, and what its parent needs of it.
struct Branch {
  std::vector<Tree::Node> nodes;
  std::uint32_t child = Tree::none;
  AreaMoments moments;
  int depth = 0;
};

std::uint32_t build(const Job& job, Items items, int level, Branch& branch, AreaMoments& moments);

/// Builds what is below a part and its box.
void build_part(const Job& job, Items part, int level, Branch& branch, Tree::Node& node,
                std::size_t lane, AreaMoments& moments) {
  AreaMoments own;
  std::uint32_t child;
  Mat3 axes;
  if (part.size() == 1) {
    child = static_cast<std::uint32_t>(&part[0] - job.all.data()) | Tree::triangle_bit;
    const auto c = job.corners(part[0]);
    own.add(c[0], c[1], c[2]);
    axes = triangle_axes(c[0], c[1], c[2]);
    ++job.advance.done;
  } else {
    child = build(job, part, level + 1, branch, own);
    axes = own.axes();
  }
  fit_box(job, part, axes, node, lane, child);
  moments.add(own);
}

std::uint32_t build(const Job& job, Items items, int level, Branch& branch, AreaMoments& moments) {
  const auto index = static_cast<std::uint32_t>(branch.nodes.size());
  branch.nodes.emplace_back();
  branch.depth = std::max(branch.depth, level);
  if (job.advance.cancelled) return index;
  const Parts parts = divide(items, level);
  Tree::Node node;
  for (std::size_t k = 0; k < parts.count; ++k)
    build_part(job, parts.part[k], level, branch, node, k, moments);
  fill_unused(node, parts.count);
  branch.nodes[index] = node;
  return index;
}

std::vector<SplitItem> items_of(const Soup& soup, const Tree& tree) {
  std::vector<SplitItem> items(soup.triangles.size());
  const double per_size = 1 / std::max((tree.high - tree.low).maxCoeff(), 1e-300);
  for (std::uint32_t i = 0; i < items.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    const Vec3 &a = soup.vertices[t[0]], &b = soup.vertices[t[1]], &c = soup.vertices[t[2]];
    const Vec3 low = (a.cwiseMin(b).cwiseMin(c) - tree.origin) * per_size;
    const Vec3 high = (a.cwiseMax(b).cwiseMax(c) - tree.origin) * per_size;
    items[i].triangle = i;
    for (int k = 0; k < 3; ++k) {
      items[i].low[k] = static_cast<float>(low[k]);
      items[i].high[k] = static_cast<float>(high[k]);
    }
  }
  return items;
}

/// Runs task(0) … task(count − 1), each once, on two threads where there is enough to do; this one
/// tells how far they are.
template <class Task>
void run(std::size_t count, Advance& advance, const Task& task) {
  constexpr std::size_t worth_a_thread = 20000;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < count; k = next++) task(k);
  };
  if (advance.total < worth_a_thread) {
    work();
    advance.report();
    return;
  }
  std::future<void> workers[] = {std::async(std::launch::async, work),
                                 std::async(std::launch::async, work)};
  for (std::future<void>& worker : workers)
    while (worker.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
      advance.report();
  for (std::future<void>& worker : workers) worker.get();
  advance.report();
}

void append(Branch& branch, Tree& tree) {
  const auto offset = static_cast<std::uint32_t>(tree.nodes.size());
  for (Tree::Node& node : branch.nodes) {
    for (std::uint32_t& child : node.child)
      if (!(child & Tree::triangle_bit)) child += offset;
    tree.nodes.push_back(node);
  }
  tree.depth = std::max(tree.depth, branch.depth);
  branch.nodes = {};
}

void grow(const Job& job, Tree& tree) {
  const Parts parts = divide(job.all, 1);
  Tree::Node top;
  std::vector<Branch> branches(parts.count);
  std::vector<AreaMoments> moments(parts.count);
  run(parts.count, job.advance,
      [&](std::size_t k) { build_part(job, parts.part[k], 1, branches[k], top, k, moments[k]); });
  if (job.advance.cancelled) throw Cancelled();
  fill_unused(top, parts.count);
  std::size_t nodes = 2;
  AreaMoments all;
  for (std::size_t k = 0; k < parts.count; ++k) {
    nodes += branches[k].nodes.size();
    all.add(moments[k]);
  }
  tree.nodes.reserve(nodes);
  tree.nodes.resize(2);
  tree.depth = 1;
  for (std::size_t k = 0; k < parts.count; ++k) {
    if (!(top.child[k] & Tree::triangle_bit))
      top.child[k] += static_cast<std::uint32_t>(tree.nodes.size());
    append(branches[k], tree);
  }
  tree.nodes[1] = top;
  fit_box(job, job.all, all.axes(), tree.nodes[0], 0, 1);
  fill_unused(tree.nodes[0], 1);
}

void reorder(Soup& soup, const std::vector<SplitItem>& items, std::vector<std::uint32_t>& order) {
  const std::vector<Triangle> old = soup.triangles;
  order.reserve(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    order.push_back(items[i].triangle);
    soup.triangles[i] = old[items[i].triangle];
  }
}

}  // namespace

std::uint32_t Tree::first_triangle(std::uint32_t slot) const {
  while (!(child(slot) & triangle_bit)) slot = child(slot) * width;
  return child(slot) & ~triangle_bit;
}

double Tree::half_sum(std::uint32_t slot) const {
  const Node& node = nodes[slot / width];
  const std::uint32_t k = slot % width;
  return static_cast<double>(node.half[0][k]) + static_cast<double>(node.half[1][k]) +
         static_cast<double>(node.half[2][k]);
}

double Tree::half_diagonal(std::uint32_t slot) const {
  const Node& node = nodes[slot / width];
  double sum = 0;
  for (const auto& half : node.half) {
    const auto h = static_cast<double>(half[slot % width]);
    sum += h * h;
  }
  return std::sqrt(sum) * (1 + 1e-12);
}

Tree build_tree(Soup& soup, std::vector<std::uint32_t>& order, const Progress& progress) {
  Tree tree;
  order.clear();
  if (soup.triangles.empty()) return tree;
  Eigen::AlignedBox3d box;
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) box.extend(soup.vertices[v]);
  tree.low = box.min();
  tree.high = box.max();
  tree.origin = tree.low + (tree.high - tree.low) / 2;
  std::vector<SplitItem> items = items_of(soup, tree);
  const double farthest = std::max(tree.low.cwiseAbs().maxCoeff(), tree.high.cwiseAbs().maxCoeff());
  Advance advance{progress, items.size()};
  grow({soup, tree.origin, 16 * std::numeric_limits<double>::epsilon() * farthest, items, advance},
       tree);
  reorder(soup, items, order);
  return tree;
}

std::size_t bytes(const Tree& tree) { return tree.nodes.capacity() * sizeof(Tree::Node); }

}  // namespace sonde
