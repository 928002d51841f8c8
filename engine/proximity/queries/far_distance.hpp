// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/proximity/queries/distance.hpp"

namespace sonde {

/// The same as triangle_distance() for bodies that are over 300 times their sizes apart, otherwise
/// no value. At that distance, the boxes of a tree, whose distances are rounded to float, no longer
/// distinguish which triangles are nearer. But the nearest triangles are then those that extend
/// furthest along the line between the bodies, and a pass over the vertices finds them. Takes some
/// ms for a million triangles, and longer only if thousands of triangles lie in faces perpendicular
/// to that line. Never allocates.
std::optional<Distance> far_distance(const Body& a, const Body& b, const Transform& X_BA);

}  // namespace sonde
