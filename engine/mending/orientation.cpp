// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"
#include "engine/mending/turned_sets.hpp"

namespace sonde {
namespace {

constexpr std::uint32_t unnumbered = std::numeric_limits<std::uint32_t>::max();
/// Maximum number of rounds over all patches. Plain cases need two; what a further round would turn
/// is capped instead.
constexpr int most_rounds = 8;

/// Where several sheets meet at an edge, uses that follow each other in the file belong together,
/// if this pairs all uses with opposite ones: so bodies that share an edge or a face stay separate.
bool pairs_up(std::span<const EdgeUse> edge) {
  if (edge.size() % 2 != 0) return false;
  for (std::size_t k = 0; k < edge.size(); k += 2)
    if (edge[k].down == edge[k + 1].down || edge[k].triangle() == edge[k + 1].triangle())
      return false;
  return true;
}

class Orienter {
 public:
  Orienter(const Soup& soup, const std::vector<EdgeUse>& uses) : soup_(soup), uses_(uses) {}

  Orientation run(const Progress& progress) {
    report(progress, 0);
    find_patches();
    report(progress, 0.4);
    turn_patches();
    report(progress, 0.6);
    find_parts();
    for (const bool t : out_.turned) out_.turned_triangles += t;
    return std::move(out_);
  }

 private:
  double area(std::size_t i) const {
    const Triangle& t = soup_.triangles[i];
    const Vec3& a = soup_.vertices[t[0]];
    return (soup_.vertices[t[1]] - a).cross(soup_.vertices[t[2]] - a).norm();
  }
  int direction(const EdgeUse& use) const {
    return use.down != out_.turned[use.triangle()] ? -1 : 1;
  }

  void find_patches() {
    const std::size_t n = soup_.triangles.size();
    TurnedSets sets(n);
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() > 2 && pairs_up(edge))
        for (std::size_t k = 0; k < edge.size(); k += 2)
          sets.join(edge[k].triangle(), edge[k + 1].triangle());
      if (edge.size() != 2 || edge[0].triangle() == edge[1].triangle()) return;
      if (!sets.join(edge[0].triangle(), edge[1].triangle(), edge[0].down == edge[1].down))
        torn_.push_back(edge[0].triangle());
    });
    out_.turned.resize(n);
    patch_.resize(n);
    std::vector<double> as_drawn(n, 0);
    for (std::uint32_t i = 0; i < n; ++i) {
      const TurnedSets::Place place = sets.find(i);
      patch_[i] = place.set;
      out_.turned[i] = place.turned;
      as_drawn[place.set] += place.turned ? -area(i) : area(i);
    }
    for (std::uint32_t i = 0; i < n; ++i)
      if (as_drawn[patch_[i]] < 0) out_.turned[i] = !out_.turned[i];
  }

  /// An edge where three patches or more meet, with each one's sum of directions.
  struct Meeting {
    std::vector<std::pair<std::uint32_t, int>> of_patch;
    double length;
  };

  void turn_patches() {
    std::vector<Meeting> meetings;
    std::map<std::uint32_t, std::vector<std::size_t>> at;  // by patch
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() < 3) return;
      Meeting m{balance(edge), (soup_.vertices[edge[0].low] - soup_.vertices[edge[0].high]).norm()};
      for (const auto& [patch, sum] : m.of_patch) at[patch].push_back(meetings.size());
      meetings.push_back(std::move(m));
    });
    std::map<std::uint32_t, bool> turned;
    for (int round = 0; round < most_rounds; ++round) {
      bool any = false;
      for (const auto& [patch, edges] : at) {
        double longer = 0, all = 0;
        for (const std::size_t k : edges) {
          long sum = 0, own = 0;
          for (const auto& [other, direction] : meetings[k].of_patch) {
            sum += direction;
            if (other == patch) own = direction;
          }
          longer +=
              meetings[k].length * static_cast<double>(std::labs(sum - 2 * own) - std::labs(sum));
          all += meetings[k].length;
        }
        if (longer >= -1e-9 * all) continue;
        any = true;
        turned[patch] = !turned[patch];
        for (const std::size_t k : edges)
          for (auto& [other, direction] : meetings[k].of_patch)
            if (other == patch) direction = -direction;
      }
      if (!any) break;
    }
    for (std::size_t i = 0; i < patch_.size(); ++i)
      if (const auto found = turned.find(patch_[i]); found != turned.end() && found->second)
        out_.turned[i] = !out_.turned[i];
  }

  /// Each patch's sum of directions at an edge, ascending by patch.
  std::vector<std::pair<std::uint32_t, int>> balance(std::span<const EdgeUse> edge) const {
    std::vector<std::pair<std::uint32_t, int>> sums;
    for (const EdgeUse& use : edge) {
      const std::uint32_t patch = patch_[use.triangle()];
      const auto found = std::find_if(sums.begin(), sums.end(),
                                      [&](const auto& sum) { return sum.first == patch; });
      if (found == sums.end())
        sums.emplace_back(patch, direction(use));
      else
        found->second += direction(use);
    }
    ordering::sort(sums.begin(), sums.end());
    return sums;
  }

  /// Joins patches that do not balance by themselves.
  void find_parts() {
    TurnedSets sets(soup_.triangles.size());
    for (std::uint32_t i = 0; i < patch_.size(); ++i) sets.join(patch_[i], i);
    for_each_edge(uses_, [&](std::span<const EdgeUse> edge) {
      if (edge.size() < 3) return;
      std::uint32_t first = unnumbered;
      for (const auto& [patch, sum] : balance(edge)) {
        if (sum == 0) continue;
        if (first == unnumbered) first = patch;
        sets.join(first, patch);
      }
    });
    std::vector<std::uint32_t> number(soup_.triangles.size(), unnumbered);
    out_.part.resize(soup_.triangles.size());
    for (std::uint32_t i = 0; i < out_.part.size(); ++i) {
      std::uint32_t& own = number[sets.set_of(i)];
      if (own == unnumbered) own = static_cast<std::uint32_t>(out_.parts++);
      out_.part[i] = own;
    }
    out_.conflicts.assign(out_.parts, 0);
    for (const std::uint32_t triangle : torn_) ++out_.conflicts[out_.part[triangle]];
  }

  const Soup& soup_;
  const std::vector<EdgeUse>& uses_;
  std::vector<std::uint32_t> patch_;
  std::vector<std::uint32_t> torn_;
  Orientation out_;
};

}  // namespace

Orientation find_orientation(const Soup& soup, const std::vector<EdgeUse>& uses,
                             const Progress& progress) {
  return Orienter(soup, uses).run(progress);
}

}  // namespace sonde
