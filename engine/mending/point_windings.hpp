// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {

/// A point on a part.
struct PartPoint {
  Vec3 x;
  std::uint32_t part;
};
/// Windings of parts around a point, ascending by part, without zeros.
using PartWindings = std::vector<std::pair<std::uint32_t, int>>;

/// The winding number of each part around each point, by a line through it in general position. A
/// part that contains the point, to rounding, does not count as around it. One pass over the
/// triangles serves all points. Throws Cancelled.
std::vector<PartWindings> part_windings(const Sealed& sealed, const std::vector<PartPoint>& points,
                                        const Progress& progress = {});

/// For each point on a closed part, points strictly inside that part beside it: along a line in
/// general position, off its surface by `near` of the way to the part's next face. Both ways where
/// the part is on both sides; none where rounding leaves it open which side is inside. Throws
/// Cancelled.
std::vector<PartPoint> points_within(const Sealed& sealed, const std::vector<PartPoint>& points,
                                     double near, const Progress& progress = {});

}  // namespace sonde
