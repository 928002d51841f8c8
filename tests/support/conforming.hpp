// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "tests/support/shapes.hpp"

namespace sonde::test {

/// How the flat faces of a shape are cut into triangles. The shape itself, and so its mass, is the
/// same to rounding however it is cut: that is what makes two cuts comparable.
struct Cutting {
  enum class Kind {
    regular,  ///< a grid, one way of diagonals
    random,   ///< grid points shifted at random in the face, diagonals by chance
    slivers   ///< every second grid line next to another: triangles 10⁴ times as long as wide
  };
  int n = 1;  ///< cells along each side of a face; 1 is the coarsest mesh there is of the shape
  Kind kind = Kind::regular;
  std::uint64_t seed = 1;
};

/// Closed, outward-facing meshes, metres.

/// A block about the origin.
PolygonSoup cut_block(const Vec3& size, const Cutting& cutting);

/// A prism on a regular polygon, which stands for a cylinder: about the origin, axis z. `radius` is
/// that of the corners; the middle of the first side is at angle π/sides.
PolygonSoup cut_rod(double radius, double length, int sides, const Cutting& cutting);
/// A square block with such a prism cut out of it from end to end. `sides` divisible by 8.
PolygonSoup cut_bored_block(double half_width, double height, double hole_radius, int sides,
                            const Cutting& cutting);

/// A V-shaped notch along y in a block; the flanks stand `notch_half_angle` off the vertical and
/// end at z = 0 at ±notch_half_width.
constexpr double notch_half_angle = 0.52;
constexpr double notch_half_width = 0.02;
PolygonSoup cut_notched_block(const Cutting& cutting);
/// The wedge whose flanks lie on those of the notch at the identity, and which touches nothing
/// else.
PolygonSoup cut_wedge(const Cutting& cutting);

/// A keyed peg, chamfered below, that stands on its tip at the origin; z is its axis.
constexpr double peg_radius = 0.01;
PolygonSoup cut_peg(const Cutting& cutting);
/// A block, its upper face z = 0, with the blind hole for the peg, wider by `clearance` all round,
/// and a mouth chamfered like the peg's tip.
constexpr double socket_depth = 0.02;
PolygonSoup cut_socket(double clearance, const Cutting& cutting);

/// A block of 1 × 1 × 0.3 m, one face of which is a wavy surface through the origin, the same for
/// both kinds: its upper face (`below`), or its lower face. The two lie on each other, and the
/// normals of the surface point up to 0.36 to any side for each 1 upwards. n × n × 4 + 8 n
/// triangles.
enum class WavyBlock { below, above };
PolygonSoup wavy_block(WavyBlock which, int n);

/// Every triangle so many times over.
PolygonSoup repeated(const PolygonSoup& soup, int times);
PolygonSoup turned(PolygonSoup soup, const Quat& q);

}  // namespace sonde::test
