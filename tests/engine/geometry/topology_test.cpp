// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/topology.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::soup_of;

Soup joined(Soup a, const Soup& b, const Vec3& by = Vec3::Zero()) {
  const auto at = static_cast<std::uint32_t>(a.vertices.size());
  for (const Vec3& x : b.vertices) a.vertices.push_back(x + by);
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + at, t[1] + at, t[2] + at});
  return a;
}

/// Each triangle with corners of its own, as STL has them.
Soup corner_by_corner(const Soup& soup) {
  Soup out;
  for (const Triangle& t : soup.triangles) {
    const auto at = static_cast<std::uint32_t>(out.vertices.size());
    for (const std::uint32_t v : t) out.vertices.push_back(soup.vertices[v]);
    out.triangles.push_back({at, at + 1, at + 2});
  }
  return out;
}

/// With vertices at one place made one, as in a body.
Topology analyse(const Soup& soup) { return analyse_topology(compacted(soup)); }
std::size_t components(const Soup& soup) { return find_components(compacted(soup)).count; }

TEST(Topology, closed_shapes) {
  for (const PolygonSoup& shape : {test::box({1, 2, 3}), test::torus(1, 0.3, 8, 6),
                                   test::sphere(1, 5, 7), test::tetrahedron(1)}) {
    const Topology t = analyse(soup_of(shape));
    EXPECT_TRUE(t.closed);
    EXPECT_EQ(components(soup_of(shape)), 1u);
    EXPECT_EQ(t.open_edges + t.nonmanifold_edges + t.misoriented_edges + t.duplicate_triangles, 0u);
  }
}

TEST(Topology, closed_corner_by_corner) {
  Soup soup = corner_by_corner(soup_of(test::box({1, 2, 3})));
  EXPECT_TRUE(analyse(soup).closed);
  EXPECT_EQ(components(soup), 1u);
}

TEST(Topology, the_two_zeros_are_one) {
  Soup soup = corner_by_corner(soup_of(test::box({2, 2, 2})));
  int k = 0;
  for (Vec3& x : soup.vertices) {
    x += Vec3::Ones();
    for (double& c : x)
      if (c == 0 && ++k % 2) c = -0.0;
  }
  EXPECT_TRUE(analyse(soup).closed);
}

TEST(Topology, a_missing_face_opens_its_edges) {
  PolygonSoup box = test::box({1, 1, 1});
  box.polygons.pop_back();
  const Topology t = analyse(soup_of(box));
  EXPECT_FALSE(t.closed);
  EXPECT_EQ(t.open_edges, 4u);
  EXPECT_EQ(t.misoriented_edges, 0u);
}

TEST(Topology, a_turned_face_is_misoriented) {
  PolygonSoup box = test::box({1, 1, 1});
  std::reverse(box.polygons[2].begin(), box.polygons[2].end());
  const Topology t = analyse(soup_of(box));
  EXPECT_FALSE(t.closed);
  EXPECT_EQ(t.open_edges, 0u);
  EXPECT_EQ(t.misoriented_edges, 4u);
}

TEST(Topology, a_moebius_band_is_open) {
  Soup soup;
  const int n = 10;
  for (int i = 0; i < n; ++i)
    for (const double side : {-0.3, 0.3}) {
      const double a = 2 * M_PI * i / n;
      const double r = 1 + side * std::cos(a / 2);
      soup.vertices.push_back({r * std::cos(a), r * std::sin(a), side * std::sin(a / 2)});
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool last = i + 1 == n;  // joined with a half turn
    const std::uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    soup.triangles.push_back({a, c, b});
    soup.triangles.push_back({b, c, d});
  }
  const Topology t = analyse(soup);
  EXPECT_EQ(t.open_edges, 2u * n);
  EXPECT_EQ(t.misoriented_edges, 1u);
}

TEST(Topology, duplicates_of_a_closed_mesh_stay_closed) {
  const Soup box = soup_of(test::box({1, 1, 1}));
  const Topology t = analyse(joined(box, box));
  EXPECT_TRUE(t.closed);
  EXPECT_EQ(t.duplicate_triangles, 12u);
  EXPECT_EQ(t.nonmanifold_edges, 18u);
  EXPECT_EQ(components(joined(box, box)), 1u);
}

TEST(Topology, three_triangles_at_an_edge) {
  Soup soup;
  soup.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  soup.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const Topology t = analyse(soup);
  EXPECT_EQ(t.nonmanifold_edges, 1u);
  EXPECT_EQ(t.misoriented_edges, 1u);
  EXPECT_EQ(t.open_edges, 6u);
  EXPECT_FALSE(t.closed);
}

TEST(Topology, components) {
  const Soup box = soup_of(test::box({1, 1, 1}));
  EXPECT_TRUE(analyse(joined(box, box, {3, 0, 0})).closed);
  const Components apart = find_components(compacted(joined(box, box, {3, 0, 0})));
  EXPECT_EQ(apart.count, 2u);
  ASSERT_EQ(apart.of.size(), 24u);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(apart.of[i], i / 12);
  EXPECT_EQ(components(joined(box, box, {1, 1, 1})), 1u);  // share one vertex
}

TEST(Topology, collapsed_triangles_do_not_open_a_mesh) {
  Soup soup = soup_of(test::box({1, 1, 1}));
  soup.triangles.push_back({0, 0, 1});
  soup.triangles.push_back({3, 3, 3});
  EXPECT_TRUE(analyse(soup).closed);
  EXPECT_EQ(find_components(compacted(soup)).of.size(), 14u);
}

TEST(Topology, nothing_is_not_closed) {
  EXPECT_FALSE(analyse(Soup()).closed);
  EXPECT_EQ(find_components(Soup()).count, 0u);
}

TEST(Topology, weld_names_the_first) {
  EXPECT_EQ(weld({{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0, 0, -0.0}, {1, 2, 3.0000000000000004}}),
            (std::vector<std::uint32_t>{0, 1, 0, 1, 4}));
}

TEST(Topology, compacted_keeps_each_place_once_in_the_order_of_use) {
  Soup soup;
  soup.vertices = {{9, 9, 9}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  soup.triangles = {{2, 3, 4}, {1, 4, 2}};
  const Soup out = compacted(soup);
  EXPECT_EQ(out.vertices, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(out.triangles, (std::vector<Triangle>{{0, 1, 2}, {1, 2, 0}}));
}

// Reference: every pair of vertices compared.
TEST(Topology, weld_agrees_with_comparing_all_pairs) {
  std::mt19937_64 random(3);
  std::vector<Vec3> vertices(500);
  for (Vec3& x : vertices)
    for (double& c : x) c = static_cast<double>(random() % 7) - 3;
  const std::vector<std::uint32_t> first = weld(vertices);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    EXPECT_EQ(first[i], std::ranges::find(vertices, vertices[i]) - vertices.begin());
}

/// The definitions, by maps over all edges and triangles.
Topology counted_plainly(const Soup& soup) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses;
  std::map<std::multiset<std::uint32_t>, std::size_t> same;
  for (const Triangle& t : soup.triangles) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    ++same[{t.begin(), t.end()}];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      ++(a < b ? uses[{a, b}].first : uses[{b, a}].second);
    }
  }
  Topology out;
  out.closed = !uses.empty();
  for (const auto& [edge, n] : uses) {
    out.open_edges += n.first + n.second == 1;
    out.nonmanifold_edges += n.first + n.second >= 3;
    out.misoriented_edges += n.first + n.second >= 2 && n.first != n.second;
    out.closed = out.closed && n.first == n.second;
  }
  for (const auto& [corners, n] : same) out.duplicate_triangles += n - 1;
  return out;
}

/// The smallest number of a component's triangles, spread until nothing changes.
std::vector<std::uint32_t> lowest_neighbour(const Soup& soup) {
  std::vector<std::uint32_t> lowest(soup.vertices.size(), ~0u), of(soup.triangles.size());
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t i = 0; i < of.size(); ++i) {
      std::uint32_t least = i;
      for (const std::uint32_t v : soup.triangles[i]) least = std::min(least, lowest[v]);
      for (const std::uint32_t v : soup.triangles[i]) {
        changed = changed || lowest[v] != least;
        lowest[v] = least;
      }
      of[i] = least;
    }
  }
  return of;
}

Soup random_indices(std::mt19937_64& random, std::size_t triangles, std::size_t vertices) {
  Soup soup;
  for (std::size_t i = 0; i < vertices; ++i)
    soup.vertices.push_back(test::random_in_ball(random, 1));
  soup.triangles.resize(triangles);
  for (Triangle& t : soup.triangles)
    for (std::uint32_t& v : t) v = static_cast<std::uint32_t>(random() % vertices);
  return soup;
}

void expect_as_counted_plainly(const Soup& soup) {
  const Topology got = analyse_topology(soup), want = counted_plainly(soup);
  EXPECT_EQ(got.open_edges, want.open_edges);
  EXPECT_EQ(got.nonmanifold_edges, want.nonmanifold_edges);
  EXPECT_EQ(got.misoriented_edges, want.misoriented_edges);
  EXPECT_EQ(got.duplicate_triangles, want.duplicate_triangles);
  EXPECT_EQ(got.closed, want.closed);
  const Components components = find_components(soup);
  const std::vector<std::uint32_t> lowest = lowest_neighbour(soup);
  const std::set<std::uint32_t> different(lowest.begin(), lowest.end());
  EXPECT_EQ(components.count, different.size());
  for (std::size_t i = 0; i < lowest.size(); ++i)  // numbered in the order of their triangles
    EXPECT_EQ(components.of[i], std::distance(different.begin(), different.find(lowest[i])));
}

// Reference: counted_plainly and lowest_neighbour. From few vertices, where everything meets, to
// many, where nothing does.
TEST(Topology, agrees_with_plain_counting) {
  std::mt19937_64 random(4);
  for (const std::size_t vertices : {3u, 5u, 20u, 100u, 1000u})
    for (int i = 0; i < 20; ++i) expect_as_counted_plainly(random_indices(random, 60, vertices));
}

TEST(Topology, agrees_with_plain_counting_where_two_threads_count) {
  std::mt19937_64 random(5);
  expect_as_counted_plainly(random_indices(random, 30000, 3000));
}

}  // namespace
}  // namespace sonde
