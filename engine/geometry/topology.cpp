// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/topology.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/base/threads.hpp"
#include "engine/geometry/union_find.hpp"

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

/// Triangles that collapse to a line or a point are ignored: their edges cancel.
bool has_repeated_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Sorts values into buckets by counting, and within each bucket by comparison: a few steps a value
/// if the keys of a mesh (the vertices of an edge) are spread over all buckets. `each_triangle(i,
/// put)` calls put(bucket, value) for the values of triangle i; `use` receives the values of each
/// bucket, ascending.
template <class Value, class EachTriangle, class Use>
void sort_into_buckets(std::size_t triangles, std::size_t buckets, const Progress& progress,
                       EachTriangle each_triangle, Use use) {
  std::vector<std::size_t> end(buckets + 1, 0);
  for_each_index(triangles, part_of(progress, 0, 0.2), [&](std::size_t i) {
    each_triangle(i, [&](std::uint32_t bucket, Value) { ++end[bucket + 1]; });
  });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Value> values(end.back());
  // While values are stored, end[b] moves from the start of bucket b to its end.
  for_each_index(triangles, part_of(progress, 0.2, 0.5), [&](std::size_t i) {
    each_triangle(i, [&](std::uint32_t bucket, Value value) { values[end[bucket]++] = value; });
  });
  std::size_t start = 0;
  for_each_index(buckets, part_of(progress, 0.5, 1), [&](std::size_t bucket) {
    const std::span<Value> range(values.data() + start, end[bucket] - start);
    ordering::sort(range.begin(), range.end());
    use(range);
    start = end[bucket];
  });
}

/// Edges in the bucket of their lower vertex; value: twice the higher one, plus one if it comes
/// second.
void count_edges(const Soup& soup, const Progress& progress, Topology& out) {
  bool any = false;
  const auto edges_of = [&](std::size_t i, auto put) {
    const Triangle& t = soup.triangles[i];
    if (has_repeated_corner(t)) return;
    any = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      put(std::min(a, b), 2 * std::max(a, b) + (a < b));
    }
  };
  const auto count = [&](std::span<const std::uint32_t> ends) {
    for (std::size_t i = 0, j = 0; i < ends.size(); i = j) {
      std::size_t up = 0;
      for (j = i; j < ends.size() && ends[j] / 2 == ends[i] / 2; ++j) up += ends[j] % 2;
      const std::size_t uses = j - i;
      out.open_edges += uses == 1;
      out.nonmanifold_edges += uses >= 3;
      out.misoriented_edges += uses >= 2 && 2 * up != uses;
    }
  };
  sort_into_buckets<std::uint32_t>(soup.triangles.size(), soup.vertices.size(), progress, edges_of,
                                   count);
  out.closed = any && out.open_edges == 0 && out.misoriented_edges == 0;
}

/// Triangles in the bucket of their lowest vertex; value: the middle one above the highest.
std::size_t count_duplicates(const Soup& soup, const Progress& progress) {
  std::size_t duplicates = 0;
  const auto corners_of = [&](std::size_t i, auto put) {
    Triangle t = soup.triangles[i];
    if (has_repeated_corner(t)) return;
    ordering::sort(t.begin(), t.end());
    put(t[0], std::uint64_t{t[1]} << 32 | t[2]);
  };
  const auto count = [&](std::span<const std::uint64_t> others) {
    for (std::size_t i = 1; i < others.size(); ++i) duplicates += others[i] == others[i - 1];
  };
  sort_into_buckets<std::uint64_t>(soup.triangles.size(), soup.vertices.size(), progress,
                                   corners_of, count);
  return duplicates;
}

}  // namespace

std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices, const Progress& progress) {
  const std::size_t slots = std::bit_ceil(2 * vertices.size() + 1);
  std::vector<std::uint32_t> table(slots, none), first(vertices.size());
  // A large table does not fit in the cache: its slots are prefetched some steps in advance.
  std::array<std::size_t, 32> ahead;
  const auto ask_for = [&](std::size_t i) {
    const std::size_t slot = hash(vertices[i]) & (slots - 1);
    __builtin_prefetch(&table[slot]);
    ahead[i % ahead.size()] = slot;
  };
  for (std::size_t i = 0; i < std::min(ahead.size(), vertices.size()); ++i) ask_for(i);
  for_each_index(vertices.size(), progress, [&](std::size_t i) {
    std::size_t slot = ahead[i % ahead.size()];
    if (i + ahead.size() < vertices.size()) ask_for(i + ahead.size());
    while (table[slot] != none && vertices[table[slot]] != vertices[i])
      slot = (slot + 1) & (slots - 1);
    if (table[slot] == none) table[slot] = static_cast<std::uint32_t>(i);
    first[i] = table[slot];
  });
  return first;
}

Soup compacted(Soup soup, const Progress& progress) {
  const std::vector<std::uint32_t> first = weld(soup.vertices, part_of(progress, 0, 0.5));
  std::vector<std::uint32_t> index(soup.vertices.size(), none);
  std::uint32_t count = 0;
  for_each_index(soup.triangles.size(), part_of(progress, 0.5, 0.8), [&](std::size_t i) {
    for (std::uint32_t& v : soup.triangles[i]) {
      std::uint32_t& number = index[first[v]];
      if (number == none) number = count++;
      v = number;
    }
  });
  std::vector<Vec3> kept(count);
  for_each_index(index.size(), part_of(progress, 0.8, 1), [&](std::size_t i) {
    if (index[i] != none) kept[index[i]] = soup.vertices[i];
  });
  soup.vertices = std::move(kept);
  return soup;
}

Topology analyse_topology(const Soup& soup, const Progress& progress) {
  Topology out;
  std::size_t duplicates = 0;
  run_both(
      soup.triangles.size() >= worth_a_thread, progress,
      [&](const Progress& part) { count_edges(soup, part, out); },
      [&](const Progress& part) { duplicates = count_duplicates(soup, part); });
  out.duplicate_triangles = duplicates;
  return out;
}

Components find_components(const Soup& soup, const Progress& progress) {
  UnionFind sets(soup.vertices.size());
  for_each_index(soup.triangles.size(), part_of(progress, 0, 0.5), [&](std::size_t i) {
    const Triangle& t = soup.triangles[i];
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  });
  std::vector<std::uint32_t> label(soup.vertices.size(), none);
  Components out;
  out.of.resize(soup.triangles.size());
  for_each_index(soup.triangles.size(), part_of(progress, 0.5, 1), [&](std::size_t i) {
    std::uint32_t& number = label[sets.find(soup.triangles[i][0])];
    if (number == none) number = static_cast<std::uint32_t>(out.count++);
    out.of[i] = number;
  });
  return out;
}

}  // namespace sonde
