// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of bodies that the proximity tests share.
#pragma once

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/support/shapes.hpp"

namespace sonde::test {

struct BodyPair {
  std::string name;
  std::shared_ptr<const Body> a, b;
};

inline PolygonSoup scaled_and_moved(PolygonSoup soup, double scale, const Vec3& by) {
  for (Vec3& x : soup.points) x = scale * x + by;
  return soup;
}

/// Soups and closed meshes of some dozen triangles each, also tiny, huge and far from the origin.
inline std::vector<BodyPair> body_pairs(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto soup = [&](int n, double size) { return random_soup(random, n, size); };
  const Vec3 far(1e6, -7e5, 3e5);
  const PolygonSoup ring = torus(0.08, 0.03, 10, 6);
  std::vector<BodyPair> out;
  out.push_back({"soup, soup", body(soup(40, 0.3)), body(soup(60, 0.3))});
  out.push_back({"soup, torus", body(soup(30, 0.2)), body(ring)});
  out.push_back({"torus, torus", body(ring), body(ring)});
  out.push_back(
      {"box, knot", body(box({0.05, 0.08, 0.1})), body(torus_knot(2, 3, 0.1, 0.04, 0.03, 20, 5))});
  out.push_back({"tiny", body(scaled_and_moved(soup(30, 0.2), 1e-6, Vec3::Zero())),
                 body(scaled_and_moved(ring, 1e-6, Vec3::Zero()))});
  out.push_back({"huge", body(scaled_and_moved(soup(30, 0.2), 1e6, Vec3::Zero())),
                 body(scaled_and_moved(ring, 1e6, Vec3::Zero()))});
  out.push_back({"far", body(scaled_and_moved(soup(30, 0.2), 1, -far)),
                 body(scaled_and_moved(ring, 1, far))});
  return out;
}

}  // namespace sonde::test
