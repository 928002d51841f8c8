// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/caps.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace sonde {
namespace {

/// The sides that are missing in one part: by the vertex they start at, where they lead to.
using Missing = std::map<std::uint32_t, std::vector<std::uint32_t>>;

/// By part; each side leads against what is there.
std::map<std::uint32_t, Missing> missing_sides(const std::vector<EdgeUse>& uses,
                                               const Orientation& orientation) {
  std::map<std::uint32_t, Missing> missing;
  std::map<std::uint32_t, int> sums;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 2) {  // nearly all: they agree
      const bool a = edge[0].down != orientation.turned[edge[0].triangle()];
      const bool b = edge[1].down != orientation.turned[edge[1].triangle()];
      const std::uint32_t p = orientation.part[edge[0].triangle()];
      if (a != b && p == orientation.part[edge[1].triangle()]) return;
    }
    sums.clear();
    for (const EdgeUse& use : edge)
      sums[orientation.part[use.triangle()]] +=
          use.down != orientation.turned[use.triangle()] ? -1 : 1;
    for (const auto& [part, sum] : sums)
      for (int k = 0; k < std::abs(sum); ++k) {
        if (sum > 0)
          missing[part][edge[0].high].push_back(edge[0].low);
        else
          missing[part][edge[0].low].push_back(edge[0].high);
      }
  });
  return missing;
}

/// Takes the sides out as loops that meet no vertex twice.
std::vector<std::vector<std::uint32_t>> loops_of(Missing missing) {
  std::vector<std::vector<std::uint32_t>> loops;
  for (auto& [start, ends] : missing)
    while (!ends.empty()) {
      std::vector<std::uint32_t> way{start};
      std::map<std::uint32_t, std::size_t> at{{start, 0}};
      while (!way.empty()) {
        std::vector<std::uint32_t>& next = missing[way.back()];
        if (next.empty()) break;  // the way is back where it began
        const std::uint32_t v = next.back();
        next.pop_back();
        const auto [seen, is_new] = at.try_emplace(v, way.size());
        if (is_new) {
          way.push_back(v);
          continue;
        }
        const auto from = way.begin() + static_cast<std::ptrdiff_t>(seen->second);
        loops.emplace_back(from, way.end());
        for (auto w = from + 1; w != way.end(); ++w) at.erase(*w);
        way.erase(from + 1, way.end());
      }
    }
  return loops;
}

}  // namespace

std::vector<Cap> find_caps(const Soup& soup, const std::vector<EdgeUse>& uses,
                           const Orientation& orientation) {
  std::vector<Cap> caps;
  for (auto& [part, missing] : missing_sides(uses, orientation))
    for (std::vector<std::uint32_t>& loop : loops_of(std::move(missing))) {
      if (loop.size() < 3) continue;  // there and back: nothing is between
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
      caps.push_back(std::move(cap));
    }
  return caps;
}

}  // namespace sonde
