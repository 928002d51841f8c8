// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/distinct.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "engine/base/progress.hpp"
#include "engine/geometry/by_corners.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/mending/doubtful_patches.hpp"
#include "engine/mending/opposed_shells.hpp"

namespace sonde {
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
    decide_doubtful_patches(soup.vertices, all, part_of(progress, 0.9, 1));
  }
  Distinct out;
  out.by.assign(soup.triangles.size(), Distinct::none);
  out.backs.assign(soup.triangles.size(), false);
  out.both_ways.assign(soup.triangles.size(), false);
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
      out.both_ways[i] = stays && same.net() == 0;
      out.backs[i] = (whole || same.once) && !stays;
    }
    for (std::size_t k = same.begin; k < same.end; ++k)  // those before the first that stays
      if (out.by[entries[k].triangle] == Distinct::none) out.by[entries[k].triangle] = last;
  }
  return out;
}

}  // namespace sonde
