// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/repeated.hpp"

#include <numeric>
#include <span>

#include "engine/base/progress.hpp"
#include "engine/geometry/by_corners.hpp"

namespace sonde {
namespace {

/// How many more of them have even than odd orientation.
long turns(std::span<const CornerTriangle> same) {
  return std::accumulate(same.begin(), same.end(), 0L,
                         [](long sum, const CornerTriangle& t) { return sum + (t.even ? 1 : -1); });
}

}  // namespace

std::vector<bool> repeated_triangles(const Soup& soup, bool solid, const Progress& progress) {
  const std::vector<CornerTriangle> all = triangles_by_corners(soup, progress);
  std::vector<std::span<const CornerTriangle>> repeated;
  long all_turns = 0;
  for_each_alike(all, [&](std::span<const CornerTriangle> same) {
    all_turns = std::gcd(all_turns, turns(same));
    if (same.size() > 1) repeated.push_back(same);
  });
  std::vector<bool> out(soup.triangles.size(), false);
  for (const std::span<const CornerTriangle> same : repeated) {
    const long left = all_turns != 0 ? turns(same) / all_turns : 0;
    long even = left > 0 ? left : left == 0, odd = left < 0 ? -left : left == 0;
    if (!solid) even = odd = 1;
    for (const CornerTriangle& t : same) {
      long& wanted = t.even ? even : odd;
      out[t.triangle] = --wanted < 0;
    }
  }
  return out;
}

}  // namespace sonde
