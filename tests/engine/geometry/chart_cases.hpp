// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "engine/geometry/chart.hpp"
#include "tests/support/pairs.hpp"

/// Probes, poses and places in the chart for the tests of charts and of motions.
namespace sonde::test::chart_cases {

/// Solids and surfaces, with the centre of mass off the origin and axes askew.
inline std::vector<std::pair<const char*, std::shared_ptr<const Body>>> bodies() {
  std::mt19937_64 random(1);
  PolygonSoup wedge = tetrahedron(0.1);
  wedge.points[0] += Vec3(0.1, 0.03, -0.02);
  const auto soup = [&] { return random_soup(random, 12, 0.2); };
  return {{"wedge", body(scaled_and_moved(wedge, 1, {0.3, -0.2, 0.1}))},
          {"box", body(box({0.05, 0.1, 0.15}))},
          {"ball", body(sphere(0.1, 6, 9))},
          {"soup", body(soup())},
          {"tiny", body(scaled_and_moved(wedge, 1e-6, Vec3::Zero()))},
          {"huge", body(scaled_and_moved(wedge, 1e6, Vec3::Zero()))},
          {"sheet", body({{{0, 0, 0}, {0.3, 0, 0}, {0, 0.1, 0}}, {{0, 1, 2}}})}};
}

inline Pose any_pose(std::mt19937_64& random, double size) {
  return {random_rotation(random), random_in_ball(random, 3 * size)};
}

/// y with |v| of at most `turn`.
inline Vec6 random_y(std::mt19937_64& random, const Body& body, double turn, double shift) {
  Vec6 y;
  y.head<3>() = 2 * body.mass.inertia.cwiseSqrt().cwiseProduct(random_in_ball(random, turn));
  y.tail<3>() = random_in_ball(random, shift);
  return y;
}

inline double pose_difference(const Body& body, const Pose& X, const Pose& Y) {
  double worst = 0;
  for (const Vec3& x : body.soup.vertices) worst = std::max(worst, (X * x - Y * x).norm());
  return worst;
}

inline double size_of(const Body& body) { return body.mass.radius + body.mass.com.norm(); }

}  // namespace sonde::test::chart_cases
