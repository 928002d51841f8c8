// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/doubtful_patches.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "engine/mending/edge_uses.hpp"
#include "engine/mending/seams.hpp"
#include "engine/mending/turned_sets.hpp"

namespace sonde {
namespace {

bool is_doubtful(const SameTriangles& same) {
  return same.size() >= 2 && (same.wanted != 1 || same.shared) && !same.decided;
}

class DoubtfulPatches {
 public:
  /// `once`: a triangle for each of `all`.
  DoubtfulPatches(const Soup& once, std::vector<SameTriangles>& all)
      : once_(once), all_(all), joined_(all.size()), sets_(0) {
    doubtful_.resize(all.size());
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      doubtful_[k] = is_doubtful(all[k]);
      if (doubtful_[k]) order_.push_back(k);
    }
    // Shared triangles come first: their other owners count as bodies until the contrary is found.
    std::stable_partition(order_.begin(), order_.end(),
                          [&](std::uint32_t k) { return all[k].shared; });
  }

  void decide(const Progress& progress) {
    if (order_.empty()) return;
    const std::vector<EdgeUse> uses = edge_uses(once_, part_of(progress, 0, 0.4));
    for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
      if (is_within(edge)) joined_.join(edge[0].triangle(), edge[1].triangle());
    });
    const Seams seams =
        find_seams(once_, uses,
                   {[this](std::span<const EdgeUse> edge) { return may_be_open(edge); },
                    [this](const std::vector<EdgeUse>& tried) { return border_decided_by(tried); }},
                   part_of(progress, 0.4, 1));
    border_decided_by(seams.uses);
    for (const std::uint32_t k : order_) {
      all_[k].once = stays_[sets_.set_of(k)];
      all_[k].wanted = all_[k].once ? 1 : all_[k].wanted / 2 * 2;
    }
  }

 private:
  /// The decision on one patch may depend on those of its neighbours, hence rounds.
  static constexpr int most_rounds = 8;
  /// Share of the length of a rim, by which lengths that are equal may differ.
  static constexpr double rounding = 1e-9;
  /// An edge of a doubtful triangle.
  struct Edge {
    std::vector<std::uint32_t> doubtful;
    bool odd = false;   // an odd number of others stay
    double length = 0;  // m
  };

  /// Whether an edge is inside a patch. Where more than two meet, as a skin and a wall do, each is
  /// a patch of its own.
  bool is_within(std::span<const EdgeUse> edge) const {
    return edge.size() == 2 && doubtful_[edge[0].triangle()] && doubtful_[edge[1].triangle()];
  }

  /// Whether it is open if some of the doubtful triangles stay, and others do not.
  bool may_be_open(std::span<const EdgeUse> edge) const {
    if (is_within(edge)) return false;
    bool odd = false, any = false;
    for (const EdgeUse& use : edge) {
      any = any || doubtful_[use.triangle()];
      odd ^= all_[use.triangle()].wanted % 2 != 0;
    }
    return any || odd;
  }

  /// Decides on each patch with these uses of the edges that may be open, and returns the length of
  /// the edges that are open then, m.
  double border_decided_by(const std::vector<EdgeUse>& uses) {
    sets_ = joined_;
    std::vector<Edge> edges;
    double border = 0;
    for_each_edge(uses, [&](std::span<const EdgeUse> use) {
      const Edge edge = edge_of(use);
      if (!edge.doubtful.empty())
        edges.push_back(edge);
      else if (edge.odd)
        border += edge.length;
      if (is_within(use)) sets_.join(edge.doubtful[0], edge.doubtful[1]);
    });
    std::map<std::uint32_t, std::vector<const Edge*>> rims;  // by patch (its lowest triangle)
    for (const Edge& edge : edges)
      for (const std::uint32_t k : edge.doubtful) rims[sets_.set_of(k)].push_back(&edge);
    // Initially, triangles of one orientation count as accidental, and those of both as a wall.
    stays_.clear();
    for (const std::uint32_t k : order_) stays_[sets_.set_of(k)] |= all_[k].net() != 0;
    bool changed = true;
    for (int round = 0; changed && round < most_rounds; ++round) {
      changed = false;
      for (const std::uint32_t k : order_)
        if (sets_.set_of(k) == k) changed |= decides_anew(k, rims[k]);
    }
    for (const Edge& edge : edges) border += is_open(edge) ? edge.length : 0;
    return border;
  }

  Edge edge_of(std::span<const EdgeUse> uses) const {
    Edge edge;
    edge.length = (once_.vertices[uses[0].low] - once_.vertices[uses[0].high]).norm();
    for (const EdgeUse& use : uses) {
      const std::uint32_t k = use.triangle();
      if (doubtful_[k])
        edge.doubtful.push_back(k);
      else
        edge.odd ^= all_[k].wanted % 2 != 0;
    }
    return edge;
  }

  bool is_open(const Edge& edge) {
    bool odd = edge.odd;
    for (const std::uint32_t k : edge.doubtful) odd ^= stays_[sets_.set_of(k)];
    return odd;
  }

  /// By the lengths along which the rest is open without the patch, and closed. Returns whether
  /// that changes the decision.
  bool decides_anew(std::uint32_t patch, const std::vector<const Edge*>& rim) {
    double open = 0, all = 0;
    for (const Edge* edge : rim) {
      bool odd = edge->odd, own = false;
      for (const std::uint32_t k : edge->doubtful) {
        const std::uint32_t its = sets_.set_of(k);
        if (its == patch)
          own = !own;
        else
          odd ^= stays_[its];
      }
      if (!own) continue;
      open += odd ? edge->length : -edge->length;
      all += edge->length;
    }
    if (std::abs(open) <= rounding * all || (open > 0) == stays_[patch]) return false;
    stays_[patch] = open > 0;
    return true;
  }

  const Soup& once_;
  std::vector<SameTriangles>& all_;
  std::vector<bool> doubtful_;        // of each of `all`
  std::vector<std::uint32_t> order_;  // the doubtful ones
  TurnedSets joined_, sets_;          // patches: by edges of the soup, and by edges cut
  std::map<std::uint32_t, bool> stays_;
};

}  // namespace

void decide_doubtful_patches(const std::vector<Vec3>& x, std::vector<SameTriangles>& all,
                             const Progress& progress) {
  if (std::ranges::none_of(all, is_doubtful)) return;
  Soup once;
  once.vertices = x;
  once.triangles.reserve(all.size());
  for (const SameTriangles& same : all) once.triangles.push_back(same.corners);
  DoubtfulPatches(once, all).decide(progress);
}

}  // namespace sonde
