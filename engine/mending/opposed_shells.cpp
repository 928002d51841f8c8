// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/opposed_shells.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>

#include "engine/mending/point_windings.hpp"
#include "engine/mending/turned_sets.hpp"

namespace sonde {
namespace {

class OpposedShells {
 public:
  OpposedShells(const std::vector<Vec3>& x, std::vector<SameTriangles>& all) : x_(x), all_(all) {}

  void decide(const Progress& progress) {
    find_odd_pairs();
    if (odd_.empty()) return;
    find_shells();
    if (shells_.empty()) return;
    find_rest();
    std::vector<PartPoint> points;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) add_samples(s, points);
    std::vector<std::map<std::uint32_t, std::size_t>> inside(shells_.size());
    std::vector<std::size_t> asked(shells_.size(), 0);
    const std::vector<PartWindings> around = part_windings(rest_, points, progress);
    for (std::size_t k = 0; k < points.size(); ++k) {
      ++asked[points[k].part];
      for (const auto& [part, winding] : around[k])
        if (!open_.contains(part)) ++inside[points[k].part][part];
    }
    for (std::uint32_t s = 0; s < shells_.size(); ++s)
      decide(shells_[s], std::ranges::any_of(inside[s], [&](const auto& found) {
               return found.second == asked[s];
             }));
  }

 private:
  /// Sample points on a shell that must all lie inside another part for the shell to be inside it.
  static constexpr std::size_t samples = 64;

  /// Finds triangles with an odd number of pairs, relative to how often the component occurs.
  void find_odd_pairs() {
    std::map<std::uint32_t, long> common;
    for (const SameTriangles& same : all_)
      if (same.pairs() > 0) common[same.component] = 0;
    if (common.empty()) return;
    for (const SameTriangles& same : all_)
      if (const auto found = common.find(same.component); found != common.end())
        found->second = std::gcd(found->second, std::gcd(same.net(), same.pairs()));
    for (std::uint32_t k = 0; k < all_.size(); ++k) {
      if (all_[k].pairs() == 0) continue;
      if (all_[k].pairs() / common[all_[k].component] % 2 != 0)
        odd_.push_back(k);
      else if (all_[k].net() == 0)  // perhaps two such shells share it
        all_[k].shared = true;
    }
  }

  /// Finds closed sets of those, connected by edges.
  void find_shells() {
    std::map<std::uint64_t, std::vector<std::uint32_t>> edges;  // by index in odd_
    for (std::uint32_t i = 0; i < odd_.size(); ++i)
      for (const std::uint64_t edge : edge_keys(all_[odd_[i]].corners)) edges[edge].push_back(i);
    // Where more than two meet, as a shell and a wall do, each is a shell of its own.
    TurnedSets sets(odd_.size());
    for (const auto& [key, at] : edges)
      if (at.size() == 2) sets.join(at[0], at[1]);
    std::set<std::uint32_t> open;
    for (const auto& [key, at] : edges) {
      std::map<std::uint32_t, int> uses;
      for (const std::uint32_t i : at) ++uses[sets.set_of(i)];
      for (const auto& [set, count] : uses)
        if (count % 2 != 0) open.insert(set);
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> shells;
    for (std::uint32_t i = 0; i < odd_.size(); ++i)
      if (const std::uint32_t set = sets.set_of(i); !open.contains(set))
        shells[set].push_back(odd_[i]);
    for (auto& [set, shell] : shells) shells_.push_back(std::move(shell));
  }

  /// Finds the remaining triangles (without opposed pairs), and which of their components are open.
  void find_rest() {
    rest_.soup.vertices = x_;
    std::map<std::uint64_t, std::pair<std::uint32_t, bool>> odd_edges;
    for (const SameTriangles& same : all_) {
      Triangle t = same.corners;
      if (same.net() < 0) std::swap(t[1], t[2]);
      for (long n = std::labs(same.net()); n > 0; --n) {
        rest_.soup.triangles.push_back(t);
        rest_.part.push_back(same.component);
        for (const std::uint64_t edge : edge_keys(t)) {
          auto& [component, odd] = odd_edges[edge];
          component = same.component;
          odd = !odd;
        }
      }
    }
    for (const auto& [key, edge] : odd_edges)
      if (edge.second) open_.insert(edge.first);
  }

  void add_samples(std::uint32_t s, std::vector<PartPoint>& points) const {
    const std::vector<std::uint32_t>& shell = shells_[s];
    const std::size_t stride = std::max<std::size_t>(1, shell.size() / samples);
    for (std::size_t i = 0; i < shell.size() && i / stride < samples; i += stride) {
      const Triangle& t = all_[shell[i]].corners;
      points.push_back({(x_[t[0]] + x_[t[1]] + x_[t[2]]) / 3, s});
    }
  }

  void decide(const std::vector<std::uint32_t>& shell, bool within) {
    for (const std::uint32_t k : shell) {
      SameTriangles& same = all_[k];
      if (same.net() == 0) {
        same.decided = true;
        same.once = !within;
        same.wanted = within ? 0 : 1;
      } else if (within) {
        same.decided = true;
      } else {  // it may be a wall between the two: that depends on the other
        same.shared = true;
        --same.wanted;
      }
    }
  }

  const std::vector<Vec3>& x_;
  std::vector<SameTriangles>& all_;
  std::vector<std::uint32_t> odd_;
  std::vector<std::vector<std::uint32_t>> shells_;
  Sealed rest_;
  std::set<std::uint32_t> open_;  // components
};

}  // namespace

void decide_opposed_shells(const std::vector<Vec3>& x, std::vector<SameTriangles>& all,
                           const Progress& progress) {
  OpposedShells(x, all).decide(progress);
}

}  // namespace sonde
