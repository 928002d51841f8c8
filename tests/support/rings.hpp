// SPDX-License-Identifier: GPL-3.0-or-later
// Walls between rings of corners about an axis, and lids on them.
#pragma once

#include <cstddef>

#include "engine/geometry/soup.hpp"

namespace sonde::test {

/// Triangles between two rings of n corners each, which begin at these corners of the soup. They
/// look away from the axis, or towards it; their edges are the same, so that a hollow matches what
/// fills it.
void wall_between_rings(PolygonSoup& soup, std::size_t n, std::size_t low, std::size_t high,
                        bool outwards);

/// A fan from a new corner to a ring of n.
void lid_on_ring(PolygonSoup& soup, std::size_t n, std::size_t ring, const Vec3& middle,
                 bool upwards);

}  // namespace sonde::test
