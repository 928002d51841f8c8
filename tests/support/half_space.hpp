// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/study/comparison/half_space.hpp"

namespace sonde::test {

/// depth = √PD_g of a body at X_FM against the half-space z ≤ height (half_space_separation).
inline double half_space_depth(const Body& body, const Pose& X_FM, double height,
                               std::uint64_t seed, int starts = 60) {
  return half_space_separation(body, X_FM, {Vec3::UnitZ(), height}, seed, starts).depth;
}

}  // namespace sonde::test
