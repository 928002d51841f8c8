// SPDX-License-Identifier: GPL-3.0-or-later
// The distance of two triangles in quadruple precision, with a proof.
#pragma once

#include "engine/proximity/triangles/triangle_pair.hpp"

namespace sonde::test {

#ifdef __SIZEOF_FLOAT128__
using Wide = __float128;
#else
using Wide = long double;
#endif

/// The distance lies between the two, m: `upper` is that of a point of A and a point of B, `lower`
/// the gap that the direction of these two points leaves between all corners. Two different
/// arguments, so equal bounds are the distance whatever way the points were found. In quadruple
/// precision they are equal to 1e-16 of the size but for triangles next to touching, some of them
/// thinner than 1e-16 of their length, where `lower` may be too low (down to 0).
struct WideBounds {
  double lower, upper;
};
WideBounds wide_distance(const Corners& a, const Corners& b);

/// What wide_distance finds between a point and a triangle, m.
double wide_distance(const Vec3& x, const Corners& t);

}  // namespace sonde::test
