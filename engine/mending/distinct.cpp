// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/distinct.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <numeric>

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
/// rim, and closes with one of each. Each patch of such triangles is one or the other.
class DoubtfulPatches {
 public:
  /// `corners(k)`: of all[k].
  template <class Corners>
  DoubtfulPatches(std::vector<Same>& all, const Corners& corners) : all_(all), sets_(all.size()) {
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      if (!is_doubtful(all[k])) continue;
      doubtful_.push_back(k);
      for (const std::uint64_t edge : edges_of(corners(k))) edges_[edge].doubtful.push_back(k);
    }
    if (doubtful_.empty()) return;
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      if (is_doubtful(all[k])) continue;
      for (const std::uint64_t edge : edges_of(corners(k)))
        if (const auto found = edges_.find(edge); found != edges_.end()) {
          ++found->second.others;
          found->second.odd ^= all[k].wanted % 2 != 0;
        }
    }
    // Where more meet, as a skin and a wall do, each is a patch of its own.
    for (const auto& [key, edge] : edges_)
      if (edge.doubtful.size() == 2 && edge.others == 0)
        sets_.join(edge.doubtful[0], edge.doubtful[1]);
    for (const auto& [key, edge] : edges_)
      for (const std::uint32_t k : edge.doubtful) rims_[sets_.set_of(k)].push_back(&edge);
  }

  void settle() {
    // At first: what faces one way is there by accident, what faces both is a wall.
    for (const std::uint32_t k : doubtful_) once_[sets_.set_of(k)] |= all_[k].net != 0;
    bool changed = !doubtful_.empty();
    for (int round = 0; changed && round < most_rounds; ++round) {
      changed = false;
      for (const std::uint32_t k : doubtful_) {
        const std::uint32_t patch = sets_.set_of(k);
        if (patch != k) continue;
        const int open = votes(patch);
        if (open == 0 || (open > 0) == once_[patch]) continue;
        once_[patch] = open > 0;
        changed = true;
      }
    }
    for (const std::uint32_t k : doubtful_)
      if (once_[sets_.set_of(k)]) all_[k].wanted = 1, all_[k].once = true;
  }

 private:
  /// One patch may be settled by what its neighbours are settled to be.
  static constexpr int most_rounds = 8;
  struct Edge {
    std::vector<std::uint32_t> doubtful;
    int others = 0;    // triangles that are in no doubt,
    bool odd = false;  // an odd number of which stay
  };
  static bool is_doubtful(const Same& same) {
    return same.end - same.begin >= 2 && same.wanted != 1;
  }

  /// Edges of the rim along which the rest is open without the patch, less others.
  int votes(std::uint32_t patch) {
    int open = 0;
    for (const Edge* edge : rims_[patch]) {
      bool odd = edge->odd, own = false;
      for (const std::uint32_t k : edge->doubtful) {
        const std::uint32_t its = sets_.set_of(k);
        if (its == patch)
          own = !own;
        else
          odd ^= once_[its] || all_[k].wanted % 2 != 0;
      }
      if (own) open += odd ? 1 : -1;
    }
    return open;
  }

  std::vector<Same>& all_;
  TurnedSets sets_;
  std::vector<std::uint32_t> doubtful_;
  std::map<std::uint64_t, Edge> edges_;
  std::map<std::uint32_t, std::vector<const Edge*>> rims_;  // by patch, its lowest triangle
  std::map<std::uint32_t, bool> once_;
};

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
  if (std::ranges::any_of(all, [](const Same& same) { return same.end - same.begin >= 2; }))
    DoubtfulPatches(all, [&](std::size_t k) { return entries[all[k].begin].corners; }).settle();
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
