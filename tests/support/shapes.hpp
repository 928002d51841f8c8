// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <numbers>
#include <random>

#include "engine/body/body.hpp"

namespace sonde::test {

inline constexpr double two_pi = 2 * std::numbers::pi;

/// Shapes as polygon soups, centred at the origin, metres, closed and outward-facing.
PolygonSoup box(const Vec3& size);
PolygonSoup sphere(double radius, int rings, int segments);
PolygonSoup torus(double major, double minor, int major_steps, int minor_steps);
/// A (p,q) torus knot tube.
PolygonSoup torus_knot(int p, int q, double major, double minor, double tube, int steps, int sides);
PolygonSoup tetrahedron(double size);
/// n loose triangles with corners in a cube of the given size.
PolygonSoup random_soup(std::mt19937_64& random, int n, double size);

std::shared_ptr<const Body> body(const PolygonSoup& soup, Model model = Model::automatic);

Quat random_rotation(std::mt19937_64& random);
/// Uniform in the ball of the given radius.
Vec3 random_in_ball(std::mt19937_64& random, double radius);
double uniform(std::mt19937_64& random, double low, double high);

}  // namespace sonde::test
