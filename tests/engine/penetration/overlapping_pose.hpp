// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/transform.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/pairs.hpp"

namespace sonde::test {

/// A random pose at which the bodies overlap by the exact test; `spread` as of random_pose().
inline Pose overlapping_pose(std::mt19937_64& random, const BodyPair& pair, double spread) {
  for (;;) {
    const Pose X = random_pose(random, *pair.a, *pair.b, spread);
    if (overlap(*pair.a, *pair.b, Transform(X), Doubt::exact)) return X;
  }
}

}  // namespace sonde::test
