// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "engine/body/body.hpp"
#include "tests/support/brute_force.hpp"

namespace sonde::test {

/// The triangles that bound a solid's inside, as corners.
std::vector<std::array<Vec3, 3>> boundary(const Body& solid);

/// Moments of where parallel columns see a winding number other than 0: what overlaps counts once.
/// An integration that shares no code with the engine's. `count` columns along each of two
/// directions; the error falls with about the power 1.5 of it (10⁻³ of the volume at 500).
Moments moments_by_columns(const Body& solid, int count);

}  // namespace sonde::test
