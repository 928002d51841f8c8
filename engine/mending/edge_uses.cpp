// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/edge_uses.hpp"

#include <algorithm>
#include <numeric>

#include "engine/base/ordering.hpp"
#include "engine/base/progress.hpp"

namespace sonde {

/// Bucket sort by the lower end, then comparison of the few uses in each bucket.
void sort_uses(std::vector<EdgeUse>& uses, std::size_t vertices, const Progress& progress) {
  std::vector<std::size_t> end(vertices + 1, 0);
  for (const EdgeUse& use : uses) ++end[use.low + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<EdgeUse> sorted(uses.size());
  for (const EdgeUse& use : uses) sorted[end[use.low]++] = use;
  std::size_t start = 0;
  for_each_index(vertices, progress, [&](std::size_t v) {
    ordering::sort(sorted.begin() + static_cast<std::ptrdiff_t>(start),
                   sorted.begin() + static_cast<std::ptrdiff_t>(end[v]),
                   [](const EdgeUse& x, const EdgeUse& y) {
                     return x.high != y.high ? x.high < y.high : x.side < y.side;
                   });
    start = end[v];
  });
  uses.swap(sorted);
}

std::vector<EdgeUse> edge_uses(const Soup& soup, const Progress& progress) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * soup.triangles.size());
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (std::size_t k = 0; k < 3; ++k)
      uses.push_back(edge_use(t[k], t[(k + 1) % 3], static_cast<std::uint32_t>(3 * i + k)));
  }
  sort_uses(uses, soup.vertices.size(), progress);
  return uses;
}

}  // namespace sonde
