// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/topology.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

namespace sonde {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

std::uint64_t mix(std::uint64_t h) {  // the finaliser of SplitMix64
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return h ^ (h >> 31);
}

std::uint64_t hash(const Vec3& x) {
  std::uint64_t h = 0;
  for (int i = 0; i < 3; ++i)  // + 0.0 makes the two zeros one
    h = mix(h + 0x9e3779b97f4a7c15u + std::bit_cast<std::uint64_t>(x[i] + 0.0));
  return h;
}

bool has_repeated_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// The triangles with welded corners; those that collapse to a line or a point are left out, for
/// their edges cancel.
std::vector<Triangle> welded_triangles(const Soup& soup) {
  const std::vector<std::uint32_t> first = weld(soup.vertices);
  std::vector<Triangle> triangles;
  triangles.reserve(soup.triangles.size());
  for (const Triangle& t : soup.triangles) {
    const Triangle w{first[t[0]], first[t[1]], first[t[2]]};
    if (!has_repeated_corner(w)) triangles.push_back(w);
  }
  return triangles;
}

struct Edge {
  std::uint32_t low, high;
  bool upwards;
  bool operator<(const Edge& o) const { return low != o.low ? low < o.low : high < o.high; }
  bool same(const Edge& o) const { return low == o.low && high == o.high; }
};

void count_edges(const std::vector<Triangle>& triangles, Topology& out) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0, j = 0; i < edges.size(); i = j) {
    std::size_t up = 0;
    for (j = i; j < edges.size() && edges[j].same(edges[i]); ++j) up += edges[j].upwards;
    const std::size_t uses = j - i;
    out.open_edges += uses == 1;
    out.nonmanifold_edges += uses >= 3;
    out.misoriented_edges += uses >= 2 && 2 * up != uses;
  }
  out.closed = !triangles.empty() && out.open_edges == 0 && out.misoriented_edges == 0;
}

std::size_t count_duplicates(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::sort(t.begin(), t.end());
  std::sort(triangles.begin(), triangles.end());
  const auto distinct = std::unique(triangles.begin(), triangles.end());
  return static_cast<std::size_t>(triangles.end() - distinct);
}

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices) {
  const std::size_t slots = std::bit_ceil(2 * vertices.size() + 1);
  std::vector<std::uint32_t> table(slots, none), first(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    std::size_t slot = hash(vertices[i]) & (slots - 1);
    while (table[slot] != none && vertices[table[slot]] != vertices[i])
      slot = (slot + 1) & (slots - 1);
    if (table[slot] == none) table[slot] = i;
    first[i] = table[slot];
  }
  return first;
}

void find_components(const Soup& soup, Topology& topology) {
  const std::vector<std::uint32_t> first = weld(soup.vertices);
  UnionFind sets(soup.vertices.size());
  for (const Triangle& t : soup.triangles) {
    sets.join(first[t[0]], first[t[1]]);
    sets.join(first[t[0]], first[t[2]]);
  }
  std::vector<std::uint32_t> label(soup.vertices.size(), none);
  std::uint32_t count = 0;
  topology.component_of.clear();
  topology.component_of.reserve(soup.triangles.size());
  for (const Triangle& t : soup.triangles) {
    std::uint32_t& number = label[sets.find(first[t[0]])];
    if (number == none) number = count++;
    topology.component_of.push_back(number);
  }
  topology.components = count;
}

Topology analyse_topology(const Soup& soup) {
  Topology out;
  std::vector<Triangle> triangles = welded_triangles(soup);
  count_edges(triangles, out);
  out.duplicate_triangles = count_duplicates(std::move(triangles));
  find_components(soup, out);
  return out;
}

}  // namespace sonde
