// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/caps.hpp"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "engine/base/ordering.hpp"

namespace sonde {
namespace {

/// A side that a part lacks for its edges to balance, opposite to the existing one.
struct Missing {
  std::uint32_t part, from, to;
};

std::vector<Missing> missing_sides(const std::vector<EdgeUse>& uses,
                                   const Orientation& orientation) {
  std::vector<Missing> missing;
  const auto direction = [&](const EdgeUse& use) {
    return use.down != orientation.turned[use.triangle()] ? -1 : 1;
  };
  std::vector<std::pair<std::uint32_t, int>> sums;  // of each part at an edge
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2 && direction(edge[0]) != direction(edge[1]) &&
        orientation.part[edge[0].triangle()] == orientation.part[edge[1].triangle()])
      return;  // the usual case
    sums.clear();
    for (const EdgeUse& use : edge) {
      const std::uint32_t part = orientation.part[use.triangle()];
      const auto found = std::ranges::find(sums, part, [](const auto& sum) { return sum.first; });
      if (found == sums.end())
        sums.emplace_back(part, direction(use));
      else
        found->second += direction(use);
    }
    for (const auto& [part, sum] : sums)
      for (int k = 0; k < std::abs(sum); ++k)
        missing.push_back(sum > 0 ? Missing{part, edge[0].high, edge[0].low}
                                  : Missing{part, edge[0].low, edge[0].high});
  });
  ordering::sort(missing.begin(), missing.end(), [](const Missing& a, const Missing& b) {
    return std::tie(a.part, a.from, a.to) < std::tie(b.part, b.from, b.to);
  });
  return missing;
}

/// The missing sides of one part, as loops that visit no vertex twice. At each vertex, as many
/// sides start as end.
class Loops {
 public:
  explicit Loops(std::span<const Missing> sides) : sides_(sides) {
    for (const Missing& side : sides)
      if (starts_.empty() || starts_.back() != side.from) {
        starts_.push_back(side.from);
        next_.push_back(static_cast<std::size_t>(&side - sides.data()));
      }
    next_.push_back(sides.size());
    end_.assign(next_.begin() + 1, next_.end());
    place_.assign(starts_.size(), nowhere);
  }

  std::vector<std::vector<std::uint32_t>> taken_out() {
    std::vector<std::vector<std::uint32_t>> loops;
    for (std::size_t s = 0; s < starts_.size(); ++s)
      while (next_[s] < end_[s]) follow(s, loops);
    return loops;
  }

 private:
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  std::size_t index(std::uint32_t vertex) const {
    return static_cast<std::size_t>(std::lower_bound(starts_.begin(), starts_.end(), vertex) -
                                    starts_.begin());
  }
  void follow(std::size_t start, std::vector<std::vector<std::uint32_t>>& loops) {
    std::vector<std::size_t> way{start};
    place_[start] = 0;
    while (next_[way.back()] < end_[way.back()]) {
      const std::size_t v = index(sides_[next_[way.back()]++].to);
      if (place_[v] == nowhere) {
        place_[v] = way.size();
        way.push_back(v);
        continue;
      }
      std::vector<std::uint32_t>& loop = loops.emplace_back();
      const std::size_t from = place_[v];
      for (std::size_t k = from; k < way.size(); ++k) loop.push_back(starts_[way[k]]);
      for (std::size_t k = from + 1; k < way.size(); ++k) place_[way[k]] = nowhere;
      way.resize(from + 1);
    }
    for (const std::size_t v : way) place_[v] = nowhere;
  }

  std::span<const Missing> sides_;
  std::vector<std::uint32_t> starts_;    // vertices, ascending
  std::vector<std::size_t> next_, end_;  // of each vertex: sides not used yet
  std::vector<std::size_t> place_;       // of each vertex on the current path
};

Cap cap_over(const Soup& soup, std::uint32_t part, std::vector<std::uint32_t> loop) {
  PolygonSoup polygon;
  for (const std::uint32_t v : loop) polygon.points.push_back(soup.vertices[v]);
  polygon.polygons.emplace_back(loop.size());
  for (std::size_t k = 0; k < loop.size(); ++k) polygon.polygons[0][k] = k;
  Cap cap{part, {}, {}, 0};
  for (const Triangle& t : triangulate_all(polygon).triangles) {
    const Vec3 &a = polygon.points[t[0]], &b = polygon.points[t[1]], &c = polygon.points[t[2]];
    cap.area += (b - a).cross(c - a).norm() / 2;
    cap.triangles.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
  }
  cap.loop = std::move(loop);
  return cap;
}

}  // namespace

std::vector<Cap> find_caps(const Soup& soup, const std::vector<EdgeUse>& uses,
                           const Orientation& orientation) {
  std::vector<Cap> caps;
  const std::vector<Missing> missing = missing_sides(uses, orientation);
  for (auto first = missing.begin(); first != missing.end();) {
    const auto last = std::find_if(first, missing.end(),
                                   [&](const Missing& side) { return side.part != first->part; });
    for (std::vector<std::uint32_t>& loop : Loops({first, last}).taken_out())
      if (loop.size() >= 3)  // two sides go there and back: nothing lies between
        caps.push_back(cap_over(soup, first->part, std::move(loop)));
    first = last;
  }
  return caps;
}

}  // namespace sonde
