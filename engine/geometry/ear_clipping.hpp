// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/geometry/soup.hpp"

namespace sonde {

/// Triangulates one polygon by ear clipping, in turns round the polygon so that a convex polygon
/// does not become a fan. `flat` are its corners in a plane, counter-clockwise, of about unit size;
/// `polygon` their indices in the soup. A polygon that does not cross itself is covered once. One
/// that does has no such triangulation: it gets as many triangles, with the same total signed area,
/// from the most convex corners near by, so that a large polygon takes no longer than others.
void clip_ears(const std::vector<std::size_t>& polygon, std::vector<Eigen::Vector2d> flat,
               std::vector<Triangle>& out);

/// The turn from a→b to b→c: positive to the left, zero if straight.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace sonde
