// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/proximity/queries/distance.hpp"

namespace sonde {

/// The same as triangle_distance() for bodies that are over 300 times their sizes apart,
/// otherwise no value. There the boxes of a tree, whose distances are rounded to float, no longer
/// tell which triangles are nearer. Seen from so far, those are nearest that come furthest along
/// the line between the bodies: a pass over the vertices finds them. Some ms for a million
/// triangles; longer only if thousands of triangles lie in faces that are square to that line.
/// Never allocates.
std::optional<Distance> far_distance(const Body& a, const Body& b, const Transform& X_BA);

}  // namespace sonde
