// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

struct Built {
  Soup before, after;
  std::vector<std::uint32_t> order;
  Tree tree;
};

Built build(const Soup& soup) {
  Built out{soup, soup, {}, {}};
  out.tree = build_tree(out.after, out.order);
  return out;
}

Built build(const PolygonSoup& polygons) { return build(triangulate(polygons).soup); }

/// Walks down from a node with all the boxes above it; counts the visits of each triangle.
void visit(const Built& b, std::uint32_t index, int level, std::vector<std::uint32_t>& above,
           std::vector<int>& visits, int& deepest) {
  const Tree::Node& node = b.tree.nodes.at(index);
  above.push_back(index);
  deepest = std::max(deepest, level);
  if (node.is_leaf()) {
    EXPECT_LE(node.count, Tree::leaf_size);
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
      ++visits.at(t);
      for (const std::uint32_t v : b.after.triangles.at(t))
        for (const std::uint32_t a : above)
          for (int k = 0; k < 3; ++k) {
            const double x = b.after.vertices[v][k], center = b.tree.nodes[a].center[k],
                         half = b.tree.nodes[a].half[k];
            ASSERT_LE(center - half, x);
            ASSERT_LE(x, center + half);
          }
    }
  } else {
    visit(b, node.first, level + 1, above, visits, deepest);
    visit(b, node.first + 1, level + 1, above, visits, deepest);
  }
  above.pop_back();
}

void check(const Built& b) {
  std::vector<std::uint32_t> above;
  std::vector<int> visits(b.after.triangles.size(), 0);
  int deepest = 0;
  visit(b, 0, 0, above, visits, deepest);
  EXPECT_TRUE(std::ranges::all_of(visits, [](int n) { return n == 1; }));
  EXPECT_EQ(b.tree.depth, deepest);
  EXPECT_LE(b.tree.depth, 60);
  ASSERT_EQ(b.order.size(), b.before.triangles.size());
  std::vector<std::uint32_t> sorted = b.order;
  std::ranges::sort(sorted);
  for (std::uint32_t i = 0; i < sorted.size(); ++i) {
    EXPECT_EQ(sorted[i], i);
    EXPECT_EQ(b.after.triangles[i], b.before.triangles[b.order[i]]);
  }
}

Soup of_triangles(std::size_t n, const std::function<Vec3(std::size_t, int)>& corner) {
  Soup soup;
  for (std::size_t i = 0; i < n; ++i) {
    for (int k = 0; k < 3; ++k) soup.vertices.push_back(corner(i, k));
    const auto at = static_cast<std::uint32_t>(3 * i);
    soup.triangles.push_back({at, at + 1, at + 2});
  }
  return soup;
}

TEST(Tree, EveryTriangleOnceAndInsideAllBoxesAbove) {
  std::mt19937_64 random(1);
  check(build(test::box({1, 2, 3})));
  check(build(test::torus_knot(2, 3, 1, 0.4, 0.1, 200, 12)));
  for (const int n : {1, 2, 3, 5, 100, 3000}) check(build(test::random_soup(random, n, 1)));
}

// Coordinates that single precision cannot tell apart.
TEST(Tree, BoxesHoldFarFromTheOrigin) {
  std::mt19937_64 random(2);
  Soup soup = triangulate(test::random_soup(random, 500, 1)).soup;
  for (Vec3& x : soup.vertices) x += Vec3(1e9, -3e7, 0.1);
  check(build(soup));
}

TEST(Tree, IdenticalTrianglesEndInTime) {
  const Built b =
      build(of_triangles(5000, [](std::size_t, int k) { return Vec3(k == 1, k == 2, 0); }));
  check(b);
  EXPECT_LE(b.tree.depth, 13);
}

// Each triangle half as far out and half as large as the last: uneven splits only.
TEST(Tree, ShrinkingTrianglesStayWithinDepth) {
  check(build(of_triangles(1000, [](std::size_t i, int k) -> Vec3 {
    return std::ldexp(1.0, -static_cast<int>(i)) * Vec3(1 + 0.1 * (k == 1), 0.1 * (k == 2), 0);
  })));
}

TEST(Tree, CollinearAndCoplanarSoups) {
  check(build(of_triangles(500, [](std::size_t i, int k) {  // boxes without area
    return Vec3(static_cast<double>(i) + 0.3 * k, 0, 0);
  })));
  check(build(of_triangles(500, [](std::size_t i, int k) {
    return Vec3(static_cast<double>(i % 20) + 0.3 * (k == 1), static_cast<double>(i / 20), 0);
  })));
}

TEST(Tree, DoesNotDependOnTheUnit) {
  const Soup soup = triangulate(test::torus(1, 0.3, 40, 20)).soup;
  const Built one = build(soup);
  for (const double s : {0x1p-60, 0x1p60}) {
    Soup other = soup;
    for (Vec3& x : other.vertices) x *= s;
    const Built b = build(other);
    EXPECT_EQ(b.order, one.order);
    EXPECT_EQ(b.tree.nodes.size(), one.tree.nodes.size());
    EXPECT_EQ(b.tree.nodes[0].half[0], static_cast<float>(one.tree.nodes[0].half[0] * s));
  }
}

TEST(Tree, IsReasonablyShallow) {
  EXPECT_LE(build(test::sphere(1, 100, 200)).tree.depth, 24);  // log2 of 40 000 / 2 is 14.3
}

TEST(Tree, NothingGivesAnEmptyTree) { EXPECT_TRUE(build(Soup()).tree.nodes.empty()); }

}  // namespace
}  // namespace sonde
