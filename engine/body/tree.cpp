// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/tree.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <span>

#include "engine/base/progress.hpp"
#include "engine/base/threads.hpp"
#include "engine/body/oriented_box.hpp"
#include "engine/body/split.hpp"

namespace sonde {
namespace {

constexpr std::size_t width = Tree::width;
/// From this number of triangles on, a box is fitted to the boxes below instead.
constexpr std::size_t many = 4096;
using Items = std::span<SplitItem>;

/// Progress of the build. One thread reports it; all threads stop if the report returned false.
struct Advance {
  const Progress& tell;
  std::size_t total;
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> cancelled = false;
  /// Once stopped, the callback is not called again.
  void report() {
    if (cancelled) return;
    const double fraction = static_cast<double>(done.load()) / static_cast<double>(total);
    if (tell && !tell(std::min(1.0, fraction))) cancelled = true;
  }
};

/// The data that all of the build reads.
struct Job {
  const Soup& soup;
  Vec3 origin;
  double size;   // m per unit of the items
  double slack;  // m: rounding of a corner's coordinates and of their difference from the origin
  Items all;
  Advance& advance;

  std::array<Vec3, 3> corners(const SplitItem& item) const {
    const Triangle& t = soup.triangles[item.triangle];
    return {soup.vertices[t[0]] - origin, soup.vertices[t[1]] - origin,
            soup.vertices[t[2]] - origin};
  }
};

/// Least number of levels of nodes over n items.
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

/// `told`: reports progress after each large split; null: no reports.
Parts divide(Items items, int level, Advance* told = nullptr) {
  Parts parts;
  if (items.size() <= width) {
    for (; parts.count < items.size(); ++parts.count)
      parts.part[parts.count] = items.subspan(parts.count, 1);
    return parts;
  }
  // Halving from here on keeps the depth within its limit; an uneven split might not.
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
    if (weight[heaviest] < 0 || (told != nullptr && told->cancelled)) break;
    const Items part = parts.part[heaviest];
    if (told != nullptr) told->report();
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

/// The content of a box: the triangles of a range or, if there are many, the boxes below, which are
/// small compared with the whole.
struct Content {
  Items items;
  const Tree::Node* boxes;
};

void add_corners(const Tree::Node& node, Extent& extent) {
  for (std::size_t k = 0; k < width && node.child[k] != Tree::none; ++k) {
    const auto at = [k](const float(&rows)[3][width]) {
      return Eigen::Vector3f(rows[0][k], rows[1][k], rows[2][k]).cast<double>().eval();
    };
    const Vec3 u = at(node.axis[0]), v = at(node.axis[1]), half = at(node.half);
    const Vec3 center = at(node.center);
    for (int corner = 0; corner < 8; ++corner) {
      const auto side = [corner](int axis) { return (corner >> axis & 1) ? 1.0 : -1.0; };
      extent.add(center + side(0) * half[0] * u + side(1) * half[1] * v +
                 side(2) * half[2] * u.cross(v));
    }
  }
}

Extent extent_along(const Job& job, const Content& content, const SmallAxes& axes) {
  Extent extent(axes_of(axes));
  if (content.boxes != nullptr)
    add_corners(*content.boxes, extent);
  else
    for (const SplitItem& item : content.items)
      for (const Vec3& x : job.corners(item)) extent.add(x);
  return extent;
}

/// Cost of a box with these sides: its volume, with a hundredth of its longest side added to each
/// side, so that of two flat boxes the smaller is better. Surface area would be a bad measure: a
/// thick box over a small part of a surface may have as little as a thin one, but only thin boxes
/// separate two surfaces near each other.
double cost(const Vec3& sides) {
  const double longest = sides.maxCoeff();
  return (sides / longest + Vec3::Constant(0.01)).prod() * longest * longest * longest;
}

/// The sides of the axis-aligned box in the mesh frame, to single precision.
Vec3 straight_sides(const Job& job, Items items) {
  const auto [low, high] = bounds(items);
  return job.size * (high - low).cast<double>();
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

/// Chooses the cheaper of the boxes along the principal axes and along the mesh frame's axes.
void fit_box(const Job& job, const Content& content, const Mat3& axes, Tree::Node& node,
             std::size_t lane, std::uint32_t child) {
  SmallAxes chosen = small_axes(axes);
  Extent extent = extent_along(job, content, chosen);
  if (content.items.size() > 1 &&
      cost(straight_sides(job, content.items)) < cost(extent.high - extent.low)) {
    chosen = small_axes(Mat3::Identity());
    extent = extent_along(job, content, chosen);
  }
  set_box(node, lane, chosen, small_box(extent, job.slack), child);
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

/// A part of the tree, with its nodes numbered from 0.
struct Branch {
  std::vector<Tree::Node> nodes;
  int depth = 0;
};

std::uint32_t build(const Job& job, Items items, int level, Branch& branch, AreaMoments& moments);

/// Builds the subtree of a part and its box.
void build_part(const Job& job, Items part, int level, Branch& branch, Tree::Node& node,
                std::size_t lane, AreaMoments& moments) {
  AreaMoments own;
  std::uint32_t child;
  Mat3 axes;
  const Tree::Node* boxes = nullptr;
  if (part.size() == 1) {
    child = static_cast<std::uint32_t>(&part[0] - job.all.data()) | Tree::triangle_bit;
    const auto c = job.corners(part[0]);
    own.add(c[0], c[1], c[2]);
    axes = triangle_axes(c[0], c[1], c[2]);
    ++job.advance.done;
  } else {
    child = build(job, part, level + 1, branch, own);
    axes = own.axes();
    if (part.size() >= many) boxes = &branch.nodes[child];
  }
  fit_box(job, {part, boxes}, axes, node, lane, child);
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

void find_bounds(const Soup& soup, const Progress& progress, Tree& tree) {
  Eigen::AlignedBox3d box;
  for_each_index(soup.triangles.size(), progress, [&](std::size_t i) {
    for (const std::uint32_t v : soup.triangles[i]) box.extend(soup.vertices[v]);
  });
  tree.low = box.min();
  tree.high = box.max();
  tree.origin = tree.low + (tree.high - tree.low) / 2;
}

std::vector<SplitItem> items_of(const Soup& soup, const Vec3& origin, double size,
                                const Progress& progress) {
  std::vector<SplitItem> items(soup.triangles.size());
  for_each_index(items.size(), progress, [&](std::size_t i) {
    const Triangle& t = soup.triangles[i];
    const Vec3 &a = soup.vertices[t[0]], &b = soup.vertices[t[1]], &c = soup.vertices[t[2]];
    const Vec3 low = (a.cwiseMin(b).cwiseMin(c) - origin) / size;
    const Vec3 high = (a.cwiseMax(b).cwiseMax(c) - origin) / size;
    items[i].triangle = static_cast<std::uint32_t>(i);
    for (int k = 0; k < 3; ++k) {
      items[i].low[k] = static_cast<float>(low[k]);
      items[i].high[k] = static_cast<float>(high[k]);
    }
  });
  return items;
}

/// Runs task(0) … task(count − 1), each once, on two threads if there is enough to do; this thread
/// reports the progress.
template <class Task>
void run(std::size_t count, Advance& advance, const Task& task) {
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
  const Parts parts = divide(job.all, 1, &job.advance);
  if (job.advance.cancelled) throw Cancelled();
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
  const Tree::Node* boxes = job.all.size() >= many ? &tree.nodes[1] : nullptr;
  fit_box(job, {job.all, boxes}, all.axes(), tree.nodes[0], 0, 1);
  fill_unused(tree.nodes[0], 1);
}

void reorder(Soup& soup, const std::vector<SplitItem>& items, std::vector<std::uint32_t>& order,
             const Progress& progress) {
  std::vector<Triangle> triangles(items.size());
  order.resize(items.size());
  for_each_index(items.size(), progress, [&](std::size_t i) {
    order[i] = items[i].triangle;
    triangles[i] = soup.triangles[order[i]];
  });
  soup.triangles = std::move(triangles);
}

}  // namespace

std::uint32_t Tree::first_triangle(std::uint32_t slot) const {
  while (!(child(slot) & triangle_bit)) slot = child(slot) * width;
  return child(slot) & ~triangle_bit;
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

Vec3 Tree::center(std::uint32_t slot) const {
  const auto& c = nodes[slot / width].center;
  const std::uint32_t k = slot % width;
  return origin + Eigen::Vector3f(c[0][k], c[1][k], c[2][k]).cast<double>();
}

Tree build_tree(Soup& soup, std::vector<std::uint32_t>& order, const Progress& progress) {
  Tree tree;
  order.clear();
  if (soup.triangles.empty()) return tree;
  find_bounds(soup, part_of(progress, 0, 0.05), tree);
  const double size = std::max((tree.high - tree.low).maxCoeff(), 1e-300);
  std::vector<SplitItem> items = items_of(soup, tree.origin, size, part_of(progress, 0.05, 0.1));
  const double farthest = std::max(tree.low.cwiseAbs().maxCoeff(), tree.high.cwiseAbs().maxCoeff());
  const Progress growing = part_of(progress, 0.1, 0.9);
  Advance advance{growing, items.size()};
  grow({soup, tree.origin, size, 16 * std::numeric_limits<double>::epsilon() * farthest, items,
        advance},
       tree);
  reorder(soup, items, order, part_of(progress, 0.9, 1));
  report(progress, 1);
  return tree;
}

std::size_t bytes(const Tree& tree) { return tree.nodes.capacity() * sizeof(Tree::Node); }

}  // namespace sonde
