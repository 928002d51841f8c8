// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tests/support/shapes.hpp"

namespace sonde::test {

/// Two bodies, and a motion of the probe through contact.
struct ContactPair {
  const char* name;
  std::shared_ptr<const Body> probe, fixed;
  double bottom;  ///< where the motion turns round: deep in contact, m
};

inline std::vector<ContactPair> contact_pairs() {
  std::mt19937_64 random(11);
  const auto block = body(box({0.3, 0.3, 0.1}));
  return {
      {"box on block", body(box({0.02, 0.03, 0.05})), block, 0.065},
      {"tetrahedron on block", body(tetrahedron(0.05)), block, 0.065},
      {"torus on torus", body(torus(0.04, 0.015, 16, 10)), body(torus(0.06, 0.02, 16, 10)), 0.025},
      {"soup on block", body(random_soup(random, 10, 0.05)), block, 0.065},
  };
}

/// Comes down from above, wanders about in contact while it turns, and leaves again; x in 0..1.
inline Pose contact_path(const ContactPair& pair, double x) {
  const double turn = 2 * std::numbers::pi * x;
  const double height = pair.bottom + 0.06 * (0.5 + 0.5 * std::cos(turn));
  const Quat q(Eigen::AngleAxisd(0.7 * std::sin(turn), Vec3(1, 2, 3).normalized()));
  return {q, Vec3(0.01 * std::sin(3 * turn), 0.01 * std::cos(2 * turn), height)};
}

}  // namespace sonde::test
