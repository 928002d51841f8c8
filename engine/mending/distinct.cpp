// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/distinct.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <unordered_map>

#include "engine/base/progress.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/mending/turned_sets.hpp"

namespace sonde {
namespace {

struct Entry {
  Triangle corners;  // ascending
  std::uint32_t triangle;
  bool even;  // orientation
};

/// Entries of the same three corners.
struct Same {
  std::size_t begin, end;
  long net;           // even ones less the others
  long wanted = 1;    // how many stay
  bool once = false;  // one stays, whatever the net
};

Entry entry_of(const Soup& soup, std::size_t i) {
  Triangle t = soup.triangles[i];
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  const bool even = t[1] < t[2];
  if (!even) std::swap(t[1], t[2]);
  return {t, static_cast<std::uint32_t>(i), even};
}

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}
std::array<std::uint64_t, 3> edges_of(const Triangle& t) {
  return {edge_key(t[0], t[1]), edge_key(t[1], t[2]), edge_key(t[2], t[0])};
}

/// Triangles that are there several times, not as often as the rest of their component: either
/// walls and shells in their own right (between two bodies, of a part within another), at whose rim
/// the rest closes without them; or repeated by accident, and then the rest is open along their
/// rim, and closes with one of each. `corners(k)`: of all[k].
template <class Corners>
void keep_one_where_the_rest_is_open(std::vector<Same>& all, const Corners& corners) {
  struct Rim {
    std::uint32_t doubtful = 0, first = 0;  // triangles of these, and one of them
    bool odd = false;                       // the others that stay
  };
  const auto is_doubtful = [](const Same& same) {
    return same.end - same.begin >= 2 && same.wanted != 1;
  };
  if (std::ranges::none_of(all, is_doubtful)) return;
  std::unordered_map<std::uint64_t, Rim> edges;
  TurnedSets patches(all.size());
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    if (!is_doubtful(all[k])) continue;
    for (const std::uint64_t edge : edges_of(corners(k))) {
      Rim& rim = edges[edge];
      if (rim.doubtful++ > 0)
        patches.join(rim.first, k);
      else
        rim.first = k;
    }
  }
  for (std::uint32_t k = 0; k < all.size(); ++k) {
    if (all[k].wanted % 2 == 0 || is_doubtful(all[k])) continue;
    for (const std::uint64_t edge : edges_of(corners(k)))
      if (const auto rim = edges.find(edge); rim != edges.end()) rim->second.odd ^= true;
  }
  std::vector<int> open(all.size(), 0);  // by patch: edges of the rim that need one, less others
  for (const auto& [edge, rim] : edges)
    if (rim.doubtful % 2 == 1) open[patches.set_of(rim.first)] += rim.odd ? 1 : -1;
  for (std::uint32_t k = 0; k < all.size(); ++k)
    if (is_doubtful(all[k]) && open[patches.set_of(k)] > 0) all[k].wanted = 1, all[k].once = true;
}

}  // namespace

Distinct find_distinct(const Soup& soup, const Progress& progress) {
  std::vector<Entry> entries(soup.triangles.size());
  for_each_index(entries.size(), part_of(progress, 0, 0.3),
                 [&](std::size_t i) { entries[i] = entry_of(soup, i); });
  std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
    return x.corners != y.corners ? x.corners < y.corners : x.triangle < y.triangle;
  });
  const Components components = find_components(soup, part_of(progress, 0.5, 0.7));
  std::vector<Same> all;
  std::vector<long> common(components.count, 0);
  for (std::size_t i = 0, j = 0; i < entries.size(); i = j) {
    long net = 0;
    for (j = i; j < entries.size() && entries[j].corners == entries[i].corners; ++j)
      net += entries[j].even ? 1 : -1;
    all.push_back({.begin = i, .end = j, .net = net});
    long& shared = common[components.of[entries[i].triangle]];
    shared = std::gcd(shared, net);
  }
  for (Same& same : all)
    if (const long shared = common[components.of[entries[same.begin].triangle]]; shared != 0)
      same.wanted = std::labs(same.net) / shared;
  keep_one_where_the_rest_is_open(all,
                                  [&](std::size_t k) { return entries[all[k].begin].corners; });
  Distinct out;
  out.by.assign(soup.triangles.size(), Distinct::none);
  out.backs.assign(soup.triangles.size(), false);
  for (const Same& same : all) {
    const std::uint32_t first = entries[same.begin].triangle;
    const bool whole = common[components.of[first]] == 0;  // each against another one
    const bool even = same.net == 0 ? entries[same.begin].even : same.net > 0;
    long wanted = same.wanted;
    std::uint32_t last = Distinct::none;
    for (std::size_t k = same.begin; k < same.end; ++k) {
      const std::uint32_t i = entries[k].triangle;
      const bool stays = entries[k].even == even && wanted > 0;
      if (stays) last = i, --wanted;
      out.by[i] = stays ? i : last;
      out.repeated += !stays;
      out.backs[i] = (whole || same.once) && !stays;
    }
    for (std::size_t k = same.begin; k < same.end; ++k)  // those before the first that stays
      if (out.by[entries[k].triangle] == Distinct::none) out.by[entries[k].triangle] = last;
  }
  return out;
}

}  // namespace sonde
