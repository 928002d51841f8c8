// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "engine/proximity/queries/placement.hpp"
#include "tests/support/pairs.hpp"

namespace sonde::test {

/// A small random motion of X about the probe's centre of mass.
inline Pose nudged(std::mt19937_64& random, const Body& a, const Pose& X, double by) {
  const Vec3 turn = random_in_ball(random, by / a.mass.radius);
  const Quat q = (Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * X.q).normalized();
  return {q, X * a.mass.com + random_in_ball(random, by) - q * a.mass.com};
}

/// A small motion of X: a turn of at most `turn` about the point of the probe at `centre` (mesh
/// frame), and that point moved by at most `by`.
inline Pose rolled(std::mt19937_64& random, const Pose& X, const Vec3& centre, double by,
                   double turn) {
  const Vec3 about = random_in_ball(random, turn);
  const Quat q = (Quat(Eigen::AngleAxisd(about.norm(), about.normalized())) * X.q).normalized();
  return {q, X * centre + random_in_ball(random, by) - q * centre};
}

/// What rounding may make of a distance at X.
inline double rounding_at(const BodyPair& pair, const Pose& X) {
  return 1e-14 * (extent(*pair.a) + extent(*pair.b) + X.p.cwiseAbs().maxCoeff());
}

}  // namespace sonde::test
