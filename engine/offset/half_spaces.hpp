// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// The points x with normal·x ≥ least. The normal is a unit vector; lengths in metres.
struct HalfSpace3 {
  Vec3 normal;
  double least = 0;
};

/// The point of all half-spaces together that is nearest to `from`; none where they have no point
/// in common. Accurate to about `rounding` (m), by which a half-space may be missed. The order of
/// the half-spaces decides only the last bits.
std::optional<Vec3> nearest_in(const std::vector<HalfSpace3>& spaces, const Vec3& from,
                               double rounding);

/// The point nearest to the origin of those whose squared distances from all the planes normal·x =
/// least sum up to the least: on all the planes, where they have a point in common.
Vec3 nearest_to_planes(const std::vector<HalfSpace3>& spaces);

}  // namespace sonde
