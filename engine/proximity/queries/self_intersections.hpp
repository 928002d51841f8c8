// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Which triangles of a mesh go through others of it.
struct SelfIntersections {
  std::vector<std::uint32_t> triangles;  ///< ascending, each once
  std::size_t pairs = 0;                 ///< of triangles that meet
  bool all = true;                       ///< false: there are more than were looked for
};

/// Exact, of a soup with one vertex for each place and no degenerate triangle (Body::soup). Two
/// triangles meet where they have more in common than the corners or the edge that they share;
/// those with the same three corners are repeated, and no crossing. Ends at `most` pairs. The
/// progress is a guess of how many pairs there are to look at. Throws Cancelled.
SelfIntersections self_intersections(const Soup& soup, const Progress& progress = {},
                                     std::size_t most = 1'000'000);

/// The pairs themselves, by the same rules: visit(a, b) says whether to go on. Their order is the
/// same for the same soup.
void for_each_meeting(const Soup& soup,
                      const std::function<bool(std::uint32_t, std::uint32_t)>& visit,
                      const Progress& progress = {});

}  // namespace sonde
