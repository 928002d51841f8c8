// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// The triangles of a mesh that intersect others of it.
struct SelfIntersections {
  std::vector<std::uint32_t> triangles;  ///< ascending, each once
  std::size_t pairs = 0;                 ///< number of pairs of triangles that meet
  bool all = true;                       ///< false: the limit was reached, and there are more
};

/// Exact, for a soup without duplicate vertices and without degenerate triangles (Body::soup). Two
/// triangles meet if they have more in common than the corners or the edge that they share; two
/// triangles with the same three corners are duplicates and do not count as meeting. Ends at `most`
/// pairs. The progress is estimated from the expected number of pairs. Throws Cancelled.
SelfIntersections self_intersections(const Soup& soup, const Progress& progress = {},
                                     std::size_t most = 1'000'000);

/// Calls visit(a, b) for the pairs themselves, by the same rules, until it returns false. Their
/// order is the same for the same soup.
void for_each_meeting(const Soup& soup,
                      const std::function<bool(std::uint32_t, std::uint32_t)>& visit,
                      const Progress& progress = {});

}  // namespace sonde
