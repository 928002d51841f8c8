// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <vector>

#include "engine/geometry/rotation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {

/// Two trefoils of 960 triangles, all lengths times `size`.
inline Pair knots(double size = 1) {
  const auto knot = body(torus_knot(2, 3, 0.06 * size, 0.025 * size, 0.012 * size, 60, 8));
  return {knot, knot};
}

/// A path of a probe that is put anywhere about a knot of that size, from row to row.
inline std::vector<Pose> teleports(int count, double size = 1) {
  std::mt19937_64 random(40);
  std::uniform_real_distribution<double> along(-1, 1);
  std::vector<Pose> out;
  for (int i = 0; i < count; ++i) {
    const Vec3 turn(3 * along(random), 3 * along(random), 3 * along(random));
    const Vec3 at(0.12 * along(random), 0.12 * along(random), 0.06 * along(random));
    out.push_back({rotation_by(turn), size * at});
  }
  return out;
}

}  // namespace sonde::test
