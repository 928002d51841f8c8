// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// The axis of a round face: a bore, a shaft, a rounded edge.
struct RoundFace {
  Vec3 at = Vec3::Zero(), along = Vec3::Zero();  ///< a point of the axis, and its direction, unit
  double radius = 0;                             ///< m, to the corners
};

/// Of the cylinder that a triangle is of, as far as the flat pieces next to it say: they meet in
/// lines along the axis, with their corners on one circle about it. None where they do not: the
/// face is flat, or round in another way. Vertices that are one have one index.
std::optional<RoundFace> round_face(const Soup& soup, std::uint32_t triangle);

}  // namespace sonde
