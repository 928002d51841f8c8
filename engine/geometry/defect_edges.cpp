// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/defect_edges.hpp"

#include <algorithm>

#include "engine/base/ordering.hpp"

namespace sonde {
namespace {

/// One use of an edge by a triangle.
struct Use {
  DefectEdges::Edge edge;  ///< the lower vertex first
  bool backwards;
};

std::vector<Use> uses_of(const Soup& soup) {
  std::vector<Use> uses;
  uses.reserve(3 * soup.triangles.size());
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t.at(i), b = t.at((i + 1) % 3);
      if (a != b) uses.push_back({{std::min(a, b), std::max(a, b)}, a > b});
    }
  ordering::sort(uses, {}, &Use::edge);
  return uses;
}

}  // namespace

DefectEdges defect_edges(const Soup& soup) {
  DefectEdges found;
  const std::vector<Use> uses = uses_of(soup);
  for (auto first = uses.begin(); first != uses.end();) {
    const auto last =
        std::find_if(first, uses.end(), [&](const Use& use) { return use.edge != first->edge; });
    const auto all = last - first;
    const auto backwards = std::count_if(first, last, [](const Use& use) { return use.backwards; });
    if (all == 1)
      found.open.push_back(first->edge);
    else if (2 * backwards != all)
      found.flipped.push_back(first->edge);
    first = last;
  }
  return found;
}

}  // namespace sonde
