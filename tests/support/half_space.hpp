// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/geometry/body.hpp"

namespace sonde::test {

/// depth = √PD_g of a body at X_FM against the half-space z ≤ height, by its definition: the
/// minimum over rotations of max(0, depth(v))² + 4vᵀÎv, where depth(v) is how far the lowest vertex
/// lies under the plane after the turn. Three unknowns, searched without derivatives (the function
/// has kinks where the lowest vertex changes) from many starts. An upper bound of the true value;
/// the search is global in practice for bodies of some hundred vertices, which two seeds that agree
/// bear out.
double half_space_depth(const Body& body, const Pose& X_FM, double height, std::uint64_t seed,
                        int starts = 60);

}  // namespace sonde::test
