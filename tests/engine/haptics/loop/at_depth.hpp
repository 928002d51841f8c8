// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde::test {

/// A box of 0.02 × 0.03 × 0.05 upright, so deep in the top of a block 0.1 high, and aside by `x`.
inline Pose at_depth(double depth, double x = 0) {
  return {Quat::Identity(), Vec3(x, 0, 0.075 - depth)};
}

}  // namespace sonde::test
