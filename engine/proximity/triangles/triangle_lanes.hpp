// SPDX-License-Identifier: GPL-3.0-or-later
// closest_points (triangle_pair.hpp) for eight pairs of triangles at a time.
#pragma once

#include <cstddef>

#include "engine/proximity/triangles/triangle_pair.hpp"
#include "engine/simd/instruction_set.hpp"

namespace sonde {

/// Up to eight pairs of triangles: [corner][coordinate][lane], in one frame for both of a pair; m.
struct alignas(64) TrianglePairs8 {
  double a[3][3][8] = {};
  double b[3][3][8] = {};
};

/// The results of closest_points in each lane: [coordinate][lane], m.
struct alignas(64) ClosestPoints8 {
  double a[3][8];       ///< a point of A; equal to b if they meet
  double b[3][8];       ///< a point of B
  double distance[8];   ///< 0: they meet; infinite: beyond the limit, the rest is invalid
  double normal[3][8];  ///< unit, from b to a; invalid at distance 0
  double gap[8];        ///< gap_along the normal; at distance 0 it is 0
};

inline Vec3 on_a(const ClosestPoints8& p, int lane) {
  return {p.a[0][lane], p.a[1][lane], p.a[2][lane]};
}
inline Vec3 on_b(const ClosestPoints8& p, int lane) {
  return {p.b[0][lane], p.b[1][lane], p.b[2][lane]};
}
inline Vec3 normal(const ClosestPoints8& p, int lane) {
  return {p.normal[0][lane], p.normal[1][lane], p.normal[2][lane]};
}

inline void set_lane(TrianglePairs8& pairs, int lane, const Corners& a, const Corners& b) {
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < 3; ++c) {
      pairs.a[k][c][lane] = a[static_cast<std::size_t>(k)][c];
      pairs.b[k][c][lane] = b[static_cast<std::size_t>(k)][c];
    }
}

/// Closest points in the first `count` lanes (1 to 8), and the direction that separates best
/// (triangle_pair.hpp). The other lanes may hold anything; their results are unspecified.
/// Degenerate triangles are allowed; edges and distances of 1e-35 to 1e35 m, or 0.
///
/// Plain floating point, relative to the triangles themselves: the distance and the gap are
/// accurate to 1e-15 of the size of the pair (its edges and its distance), the points to that and
/// the rounding of their coordinates. Triangles found to be further apart than `limit` (≥ 0, m) may
/// get an infinite distance; triangles within it never do. The same bits on every processor and in
/// every lane, whatever the other lanes hold. Never allocates.
void closest_points(const TrianglePairs8& pairs, int count, double limit, ClosestPoints8& out);

/// closest_points by one instruction set, which must be supported.
void closest_points_by(InstructionSet set, const TrianglePairs8& pairs, int count, double limit,
                       ClosestPoints8& out);

}  // namespace sonde
