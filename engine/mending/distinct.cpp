// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/distinct.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <numeric>

#include "engine/base/progress.hpp"
#include "engine/geometry/by_corners.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/mending/opposed_shells.hpp"
#include "engine/mending/turned_sets.hpp"

namespace sonde {
namespace {

/// Triangles that occur more often than the rest of their component. They are either walls and
/// shells of their own (between two bodies, or of a part within another), and the rest closes along
/// their rim without them; or they are repeated by accident, and the rest is open along their rim,
/// and closes with one of each. Each patch of such triangles is one or the other.
class DoubtfulPatches {
 public:
  explicit DoubtfulPatches(std::vector<SameTriangles>& all) : all_(all), sets_(all.size()) {
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      if (!is_doubtful(all[k])) continue;
      doubtful_.push_back(k);
      for (const std::uint64_t edge : edge_keys(all[k].corners)) edges_[edge].doubtful.push_back(k);
    }
    if (doubtful_.empty()) return;
    // Shared triangles come first: their other owners count as bodies until the contrary is found.
    std::stable_partition(doubtful_.begin(), doubtful_.end(),
                          [&](std::uint32_t k) { return all[k].shared; });
    for (const SameTriangles& same : all) {
      if (is_doubtful(same)) continue;
      for (const std::uint64_t edge : edge_keys(same.corners))
        if (const auto found = edges_.find(edge); found != edges_.end()) {
          ++found->second.others;
          found->second.odd ^= same.wanted % 2 != 0;
        }
    }
    // Where more than two meet, as a skin and a wall do, each is a patch of its own.
    for (const auto& [key, edge] : edges_)
      if (edge.doubtful.size() == 2 && edge.others == 0)
        sets_.join(edge.doubtful[0], edge.doubtful[1]);
    for (const auto& [key, edge] : edges_)
      for (const std::uint32_t k : edge.doubtful) rims_[sets_.set_of(k)].push_back(&edge);
  }

  void decide() {
    // Initially, triangles of one orientation count as accidental, and those of both as a wall.
    for (const std::uint32_t k : doubtful_) once_[sets_.set_of(k)] |= all_[k].net() != 0;
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
    for (const std::uint32_t k : doubtful_) {
      all_[k].once = once_[sets_.set_of(k)];
      all_[k].wanted = all_[k].once ? 1 : all_[k].wanted / 2 * 2;
    }
  }

 private:
  /// The decision on one patch may depend on those of its neighbours, hence rounds.
  static constexpr int most_rounds = 8;
  struct Edge {
    std::vector<std::uint32_t> doubtful;
    int others = 0;    // triangles that are not doubtful
    bool odd = false;  // an odd number of which stay
  };
  static bool is_doubtful(const SameTriangles& same) {
    return same.size() >= 2 && (same.wanted != 1 || same.shared) && !same.decided;
  }

  /// Number of rim edges along which the rest is open without the patch, minus the others.
  int votes(std::uint32_t patch) {
    int open = 0;
    for (const Edge* edge : rims_[patch]) {
      bool odd = edge->odd, own = false;
      for (const std::uint32_t k : edge->doubtful) {
        const std::uint32_t its = sets_.set_of(k);
        if (its == patch)
          own = !own;
        else
          odd ^= once_[its];
      }
      if (own) open += odd ? 1 : -1;
    }
    return open;
  }

  std::vector<SameTriangles>& all_;
  TurnedSets sets_;
  std::vector<std::uint32_t> doubtful_;
  std::map<std::uint64_t, Edge> edges_;
  std::map<std::uint32_t, std::vector<const Edge*>> rims_;  // by patch (its lowest triangle)
  std::map<std::uint32_t, bool> once_;
};

}  // namespace

Distinct find_distinct(const Soup& soup, const Progress& progress) {
  const std::vector<CornerTriangle> entries = triangles_by_corners(soup, part_of(progress, 0, 0.5));
  const Components components = find_components(soup, part_of(progress, 0.5, 0.7));
  std::vector<SameTriangles> all;
  std::vector<long> common(components.count, 0);
  for_each_alike(entries, [&](std::span<const CornerTriangle> alike) {
    const auto begin = static_cast<std::size_t>(alike.data() - entries.data());
    SameTriangles same{.corners = alike[0].corners,
                       .component = components.of[alike[0].triangle],
                       .begin = begin,
                       .end = begin + alike.size()};
    for (const CornerTriangle& t : alike) ++(t.even ? same.evens : same.odds);
    long& shared = common[same.component];
    shared = std::gcd(shared, same.net());
    all.push_back(same);
  });
  for (SameTriangles& same : all)
    if (const long shared = common[same.component]; shared != 0)
      same.wanted = std::labs(same.net()) / shared;
  if (std::ranges::any_of(all, [](const SameTriangles& same) { return same.size() >= 2; })) {
    decide_opposed_shells(soup.vertices, all, part_of(progress, 0.7, 0.9));
    DoubtfulPatches(all).decide();
  }
  Distinct out;
  out.by.assign(soup.triangles.size(), Distinct::none);
  out.backs.assign(soup.triangles.size(), false);
  for (const SameTriangles& same : all) {
    const bool whole = common[same.component] == 0 && same.wanted > 0;  // each has an opposite one
    const bool even = same.net() == 0 ? entries[same.begin].even : same.net() > 0;
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
