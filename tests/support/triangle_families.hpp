// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of triangles of every kind that is hard on a kernel.
#pragma once

#include <random>
#include <span>

#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde::test {

struct TrianglePair {
  Corners a, b;
};

/// Makes pairs of size about 1 near the origin.
struct TriangleFamily {
  const char* name;
  TrianglePair (*make)(std::mt19937_64& random);
};
std::span<const TriangleFamily> triangle_families();

/// Where a pair is put: multiplied, then moved.
struct TrianglePlace {
  double scale;
  Vec3 at;
};
/// As it is, 1e-6 and 1e6 of its size, and 1e6 of its size away from the origin.
std::span<const TrianglePlace> triangle_places();
TrianglePair placed(const TrianglePair& pair, const TrianglePlace& place);

/// The largest difference of two corners' coordinates: what rounding is measured by, m.
double size_of(const TrianglePair& pair);
/// The largest coordinate, m.
double reach_of(const TrianglePair& pair);

}  // namespace sonde::test
