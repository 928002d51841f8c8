// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/body/tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "engine/body/oriented_box.hpp"
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

/// Is x in the box of a slot, as the tree's documentation says it?
testing::AssertionResult holds(const Tree& tree, std::uint32_t slot, const Vec3& x) {
  const Tree::Node& node = tree.nodes.at(slot / Tree::width);
  const std::uint32_t k = slot % Tree::width;
  const Vec3 center(node.center[0][k], node.center[1][k], node.center[2][k]);
  SmallAxes axes;
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t c = 0; c < 3; ++c) axes[i][c] = node.axis[i][c][k];
  const Vec3 along = axes_of(axes).transpose() * (x - tree.origin - center);
  for (int i = 0; i < 3; ++i)
    if (!(std::abs(along[i]) <= static_cast<double>(node.half[i][k])))
      return testing::AssertionFailure() << "slot " << slot << " axis " << i << ": " << along[i]
                                         << " is beyond " << node.half[i][k];
  return testing::AssertionSuccess();
}

/// Walks down from a slot with all the boxes above it; counts the visits of each triangle.
void visit(const Built& b, std::uint32_t slot, int level, std::vector<std::uint32_t>& above,
           std::vector<int>& visits, int& deepest) {
  above.push_back(slot);
  const std::uint32_t child = b.tree.child(slot);
  if (child & Tree::triangle_bit) {
    const std::uint32_t t = child & ~Tree::triangle_bit;
    ++visits.at(t);
    for (const std::uint32_t v : b.after.triangles.at(t))
      for (const std::uint32_t box : above) ASSERT_TRUE(holds(b.tree, box, b.after.vertices[v]));
  } else {
    deepest = std::max(deepest, level + 1);
    EXPECT_EQ(b.tree.first_triangle(slot), b.tree.first_triangle(child * Tree::width));
    bool ended = false;
    for (std::uint32_t k = 0; k < Tree::width; ++k) {
      ended = ended || b.tree.nodes.at(child).child[k] == Tree::none;
      if (ended)
        EXPECT_EQ(b.tree.nodes.at(child).child[k], Tree::none);
      else
        visit(b, child * Tree::width + k, level + 1, above, visits, deepest);
    }
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
  EXPECT_LE(b.tree.depth, Tree::max_depth);
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

TEST(Tree, every_triangle_once_and_inside_all_boxes_above) {
  std::mt19937_64 random(1);
  check(build(test::box({1, 2, 3})));
  check(build(test::torus_knot(2, 3, 1, 0.4, 0.1, 200, 12)));
  for (const int n : {1, 2, 3, 5, 100, 3000}) check(build(test::random_soup(random, n, 1)));
}

// Coordinates that single precision cannot tell apart.
TEST(Tree, boxes_hold_far_from_the_origin) {
  std::mt19937_64 random(2);
  Soup soup = triangulate(test::random_soup(random, 500, 1)).soup;
  for (Vec3& x : soup.vertices) x += Vec3(1e9, -3e7, 0.1);
  check(build(soup));
}

TEST(Tree, identical_triangles_end_in_time) {
  const Built b =
      build(of_triangles(5000, [](std::size_t, int k) { return Vec3(k == 1, k == 2, 0); }));
  check(b);
  EXPECT_LE(b.tree.depth, 5);  // log16 of 5000 is 3.1
}

// Each triangle half as far out and half as large as the last: uneven splits only.
TEST(Tree, shrinking_triangles_stay_within_depth) {
  check(build(of_triangles(1000, [](std::size_t i, int k) -> Vec3 {
    return std::ldexp(1.0, -static_cast<int>(i)) * Vec3(1 + 0.1 * (k == 1), 0.1 * (k == 2), 0);
  })));
}

TEST(Tree, collinear_and_coplanar_soups) {
  check(build(of_triangles(500, [](std::size_t i, int k) {  // boxes without area
    return Vec3(static_cast<double>(i) + 0.3 * k, 0, 0);
  })));
  check(build(of_triangles(500, [](std::size_t i, int k) {
    return Vec3(static_cast<double>(i % 20) + 0.3 * (k == 1), static_cast<double>(i / 20), 0);
  })));
}

TEST(Tree, does_not_depend_on_the_unit) {
  const Soup soup = triangulate(test::torus(1, 0.3, 40, 20)).soup;
  const Built one = build(soup);
  for (const double s : {0x1p-60, 0x1p60}) {
    Soup other = soup;
    for (Vec3& x : other.vertices) x *= s;
    const Built b = build(other);
    EXPECT_EQ(b.order, one.order);
    EXPECT_EQ(b.tree.nodes.size(), one.tree.nodes.size());
    EXPECT_EQ(b.tree.nodes[0].half[0][0],
              static_cast<float>(static_cast<double>(one.tree.nodes[0].half[0][0]) * s));
  }
}

TEST(Tree, is_shallow_and_full) {
  const Built b = build(test::sphere(1, 100, 200));  // 39 600 triangles, log8 is 5.1
  EXPECT_LE(b.tree.depth, 8);
  EXPECT_LT(static_cast<double>(bytes(b.tree)) / 39600, 75);
}

// An oriented box over a small piece of a smooth surface is far thinner than it is long.
TEST(Tree, boxes_follow_the_surface) {
  const Built b = build(test::sphere(1, 100, 200));
  double worst = 0;
  for (const Tree::Node& node : b.tree.nodes)
    for (std::uint32_t k = 0; k < Tree::width && node.child[k] != Tree::none; ++k) {
      const float half[] = {node.half[0][k], node.half[1][k], node.half[2][k]};
      const double longest = *std::ranges::max_element(half),
                   thinnest = *std::ranges::min_element(half);
      // A cap of half-angle a on the unit sphere is 1 − cos a high; facets are within 5e-4 of it.
      if (longest < 0.2) worst = std::max(worst, thinnest - (1 - std::cos(2 * longest)) / 2);
    }
  EXPECT_LT(worst, 1e-3);
}

// The threads take parts as they come: what comes out must not tell.
TEST(Tree, same_bits_every_time) {
  const Soup soup = triangulate(test::sphere(1, 150, 200)).soup;
  const Built one = build(soup);
  for (int i = 0; i < 3; ++i) {
    const Built other = build(soup);
    EXPECT_EQ(other.order, one.order);
    ASSERT_EQ(other.tree.nodes.size(), one.tree.nodes.size());
    EXPECT_EQ(std::memcmp(other.tree.nodes.data(), one.tree.nodes.data(),
                          one.tree.nodes.size() * sizeof(Tree::Node)),
              0);
  }
}

TEST(Tree, can_be_cancelled) {
  Soup soup = triangulate(test::sphere(1, 150, 200)).soup;
  std::vector<std::uint32_t> order;
  double last = -1;
  build_tree(soup, order, [&](double f) {
    EXPECT_GE(f, last);
    last = f;
    return true;
  });
  EXPECT_EQ(last, 1);
  EXPECT_THROW(build_tree(soup, order, [](double) { return false; }), Cancelled);
}

TEST(Tree, nothing_gives_an_empty_tree) { EXPECT_TRUE(build(Soup()).tree.nodes.empty()); }

}  // namespace
}  // namespace sonde
