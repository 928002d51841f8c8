// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel of triangle_lanes.hpp, for the number of lanes that the including source sets
// (lanes.hpp).
#pragma once

#include "engine/base/numbers.hpp"
#include "engine/proximity/triangles/triangle_lanes.hpp"
#include "engine/simd/lanes.hpp"

namespace sonde {

/// closest_points in passes of `lanes` lanes. The processor must support the instructions.
template <int lanes>
void closest_points_in_lanes(const TrianglePairs8& pairs, int count, double limit,
                             ClosestPoints8& out);
template <>
void closest_points_in_lanes<SONDE_LANES>(const TrianglePairs8& pairs, int count, double limit,
                                          ClosestPoints8& out);

}  // namespace sonde

SONDE_LANES_BEGIN
namespace sonde::lanes {
namespace {

/// Squares of lengths, or of products of lengths, below this count as 0: their inverse stays
/// finite.
constexpr double least_square = 1e-280;

/// The inverse of a square; for 0 a finite number, so that 0 times it is 0.
inline Number inverse(Number square) {
  return broadcast(1) / larger(square, broadcast(least_square));
}

/// Edge i runs from corner i to corner i + 1.
struct Triangle {
  Vector v[3], edge[3];
  Number length2[3], inverse2[3];

  void load(const double in[3][3][8], int first) {
    for (int k = 0; k < 3; ++k) v[k] = lanes::load(in[k], first);
    for (int k = 0; k < 3; ++k) {
      edge[k] = v[(k + 1) % 3] - v[k];
      length2[k] = dot(edge[k], edge[k]);
    }
  }
  /// Renumbers the corners so that edge 2 is the longest.
  void turn() {
    const Mask first = (length2[0] >= length2[1]) & (length2[0] > length2[2]);
    const Mask second = (length2[1] > length2[0]) & (length2[1] > length2[2]);
    const Vector w[3] = {v[0], v[1], v[2]};
    const Number l[3] = {length2[0], length2[1], length2[2]};
    for (int k = 0; k < 3; ++k) {
      v[k] = select(first, w[(k + 1) % 3], select(second, w[(k + 2) % 3], w[k]));
      inverse2[k] = inverse(select(first, l[(k + 1) % 3], select(second, l[(k + 2) % 3], l[k])));
    }
    for (int k = 0; k < 3; ++k) edge[k] = v[(k + 1) % 3] - v[k];
  }
};

/// Two triangles, and the vectors r[i][j] from corner j of B to corner i of A. All later
/// computations are relative, so the distance from the origin does not matter.
struct Pairs {
  Triangle a, b;
  Vector r[3][3];

  void set_differences() {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) r[i][j] = a.v[i] - b.v[j];
  }
};

/// A triangle's plane, and the corners of the other triangle relative to it. A point projects into
/// the face if inside[0], inside[1] and normal2 − inside[0] − inside[1] are all ≥ 0: these are
/// |normal| times twice the areas over the edges 0, 1 and 2.
struct Face {
  Vector normal;  ///< right-handed for B, left-handed for A: heights then have the same sign
  Number normal2, inverse2;
  Number height[3];     ///< of the other triangle's corners, times |normal|
  Number inside[2][3];  ///< [edge][corner of the other]

  /// The cross product of the two short edges (with the caller's sign) has the smallest rounding
  /// error. In a needle without a short edge, its direction may still be wrong by up to a right
  /// angle. An error about the axis of the needle does no harm. The component along the longest
  /// edge is removed; if almost nothing remains, the triangle has no face.
  void set(const Triangle& t, const Vector& product) {
    normal = product - (dot(product, t.edge[2]) * t.inverse2[2]) * t.edge[2];
    normal2 = dot(normal, normal);
    normal2 = select(normal2 < broadcast(0.25) * dot(product, product), Number{}, normal2);
    inverse2 = inverse(normal2);
  }
  /// Evaluates corner k of the other triangle. r0 and r1 are the vectors (Pairs) between it and the
  /// corners 0 and 1 of this one; they point towards A, which is why A's normal is reversed.
  void see(const Vector inward[2], int k, const Vector& r0, const Vector& r1) {
    height[k] = dot(normal, r0);
    inside[0][k] = dot(inward[0], r0);
    inside[1][k] = dot(inward[1], r1);
  }
  /// The limit is far above the values at which the products of heights and positions in look()
  /// become denormal, and far below the thinnest triangle of 1e-35 m.
  Mask exists() const { return normal2 > broadcast(1e-200); }
  Mask on_one_side() const {
    const Number zero{};
    const Mask above = (height[0] > zero) & (height[1] > zero) & (height[2] > zero);
    const Mask below = (height[0] < zero) & (height[1] < zero) & (height[2] < zero);
    return exists() & (above | below);
  }
  /// Whether the other triangle is on one side of the plane, further from it than √reach2.
  Mask beyond(Number reach2) const {
    Number nearest = height[0] * height[0];
    for (int k = 1; k < 3; ++k) nearest = smaller(nearest, height[k] * height[k]);
    return on_one_side() & (nearest > reach2 * normal2);
  }
  Mask covers(int k) const {
    const Number zero{};
    return exists() & (inside[0][k] >= zero) & (inside[1][k] >= zero) &
           (normal2 - inside[0][k] - inside[1][k] >= zero);
  }
};

[[gnu::always_inline]] inline void set_faces(const Pairs& p, Face& a, Face& b) {
  a.set(p.a, cross(p.a.edge[1], p.a.edge[0]));
  b.set(p.b, cross(p.b.edge[0], p.b.edge[1]));
  const Vector in_a[2] = {cross(a.normal, p.a.edge[0]), cross(a.normal, p.a.edge[1])};
  const Vector in_b[2] = {cross(b.normal, p.b.edge[0]), cross(b.normal, p.b.edge[1])};
  for (int k = 0; k < 3; ++k) {
    a.see(in_a, k, p.r[0][k], p.r[1][k]);
    b.see(in_b, k, p.r[k][0], p.r[k][1]);
  }
}

/// The closest points so far: one lies at corner `anchor` of A (3 to 5: of B) plus `along` times
/// the edge from there; `apart` is the vector from B's point to A's.
struct Best {
  Number squared;
  Vector apart;
  Number anchor, along;

  void clear() { *this = {broadcast(infinity), Vector{}, Number{}, Number{}}; }
  void offer(Mask better, Number new_squared, const Vector& new_apart, Number new_anchor,
             Number new_along) {
    squared = select(better, new_squared, squared);
    apart = select(better, new_apart, apart);
    anchor = select(better, new_anchor, anchor);
    along = select(better, new_along, along);
  }
};

/// Offers corners of the other triangle that project into a face, each with its foot point.
inline void offer_corners(const Face& face, int first_anchor, Best& best) {
  for (int k = 0; k < 3; ++k) {
    const Number ratio = face.height[k] * face.inverse2;
    const Number squared = face.height[k] * ratio;
    best.offer(face.covers(k) & (squared < best.squared), squared, ratio * face.normal,
               broadcast(first_anchor + k), Number{});
  }
}

/// Closest points of the nine pairs of edges, edge k / 3 of A and k % 3 of B. The point of A
/// closest to the other line comes from cross products: for nearly parallel edges this costs no
/// accuracy of the distance (the error along the edge grows as the inverse of their angle, and
/// enters the distance only times that angle). The rest is alternating projection, clamped to the
/// edges, as in C. Ericson, Real-Time Collision Detection, 2005, 5.1.9. All pairs advance step by
/// step side by side: one pair after the other is a chain of dependent operations, and takes a
/// fifth longer.
[[gnu::always_inline]] inline void offer_edges(const Pairs& p, Best& best) {
  Number start[9], along[9], squared[9];
  Vector apart[9];
#pragma GCC unroll 9
  for (int k = 0; k < 9; ++k) {
    const Vector &u = p.a.edge[k / 3], &w = p.b.edge[k % 3], &r = p.r[k / 3][k % 3];
    const Vector n = cross(u, w);
    start[k] = dot(cross(w, r), n) / larger(dot(n, n), broadcast(least_square));
  }
#pragma GCC unroll 9
  for (int k = 0; k < 9; ++k) {
    start[k] = clamp01(start[k]);
    apart[k] = p.r[k / 3][k % 3] + start[k] * p.a.edge[k / 3];
  }
#pragma GCC unroll 9
  for (int k = 0; k < 9; ++k) {
    const Vector& w = p.b.edge[k % 3];
    apart[k] = apart[k] - clamp01(dot(apart[k], w) * p.b.inverse2[k % 3]) * w;
  }
#pragma GCC unroll 9
  for (int k = 0; k < 9; ++k) {
    const Vector& u = p.a.edge[k / 3];
    along[k] = clamp01(start[k] - dot(apart[k], u) * p.a.inverse2[k / 3]);
    apart[k] = apart[k] + (along[k] - start[k]) * u;
    squared[k] = dot(apart[k], apart[k]);
  }
#pragma GCC unroll 9
  for (int k = 0; k < 9; ++k) {
    const int i = k / 3;
    best.offer(squared[k] < best.squared, squared[k], apart[k], broadcast(i), along[k]);
  }
}

/// Points where edges of the other triangle pass through a face: at the fraction height / drop of
/// the edge from corner `anchor` (Best).
struct Piercing {
  Mask found;
  Number anchor, height, drop;

  /// A corner's position relative to the edges of the face is linear between two corners; it is
  /// compared without the division by the difference of their heights.
  void look(const Face& face, int first_anchor) {
    const Number zero{};
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3;
      const Number *h = face.height, *p = face.inside[0], *q = face.inside[1];
      const Mask falls = h[k] > zero;
      const Number fall = h[k] - h[l];
      const Number in0 = p[l] * h[k] - p[k] * h[l];
      const Number in1 = q[l] * h[k] - q[k] * h[l];
      const Number in2 = face.normal2 * fall - in0 - in1;
      const Mask all_in = (in0 >= zero) & (in1 >= zero) & (in2 >= zero);
      const Mask all_in_rising = (in0 <= zero) & (in1 <= zero) & (in2 <= zero);
      const Mask here =
          face.exists() & (falls ^ (h[l] > zero)) & ((falls & all_in) | (~falls & all_in_rising));
      anchor = select(here, broadcast(first_anchor + k), anchor);
      height = select(here, h[k], height);
      drop = select(here, fall, drop);
      found |= here;
    }
  }
};

/// If triangles meet, an edge of one passes through the other or touches it. In lanes that are no
/// candidates, one triangle lies on one side of the other's plane.
inline void offer_piercing(const Face& a, const Face& b, Mask candidates, Best& best) {
  Piercing through = {Mask{}, Number{}, Number{}, broadcast(1)};
  through.look(a, 3), through.look(b, 0);
  best.offer(candidates & through.found, Number{}, Vector{}, through.anchor,
             through.height / through.drop);
}

/// The projections of the corners on n, relative to corner 0 of B.
struct Shadow {
  Number low_a, high_a, low_b, high_b;
  Shadow(const Vector& n, const Vector& r00, const Triangle& a, const Triangle& b) {
    const Number zero{}, at = dot(n, r00);
    const Number a0 = dot(n, a.edge[0]), a2 = -dot(n, a.edge[2]);
    const Number b0 = dot(n, b.edge[0]), b2 = -dot(n, b.edge[2]);
    low_a = at + smaller(zero, smaller(a0, a2)), high_a = at + larger(zero, larger(a0, a2));
    low_b = smaller(zero, smaller(b0, b2)), high_b = larger(zero, larger(b0, b2));
  }
  /// min over A of n·a − max over B of n·b
  Number gap() const { return low_a - high_b; }
  Number gap_backwards() const { return low_b - high_a; }
};

/// Whether the gap along the line of the centroids is more than √reach2.
inline Mask far_apart(const Triangle& a, const Triangle& b, const Vector& r00, Number reach2) {
  const Vector line = broadcast(3) * r00 + (a.edge[0] - a.edge[2]) - (b.edge[0] - b.edge[2]);
  const Number gap = Shadow(line, r00, a, b).gap();
  return (gap > Number{}) & (gap * gap > reach2 * dot(line, line));
}

/// The direction with the largest gap so far.
struct Separation {
  Vector normal;
  Number gap;

  void offer(const Vector& axis, const Pairs& p, Mask wanted) {
    const Number square = dot(axis, axis);
    const Number scale = broadcast(1) / root(larger(square, broadcast(least_square)));
    const Shadow shadow(axis, p.r[0][0], p.a, p.b);
    const Number forwards = shadow.gap() * scale, backwards = shadow.gap_backwards() * scale;
    const Mask turned = backwards > forwards;
    const Number best = select(turned, backwards, forwards);
    const Mask better = wanted & (square > broadcast(least_square)) & (best > gap);
    normal = select(better, select(turned, -scale, scale) * axis, normal);
    gap = select(better, best, gap);
  }
};

/// Removes from a direction its component along an edge. Rounding turns the direction of two points
/// that are close together, and the cross product of two edges that are nearly parallel. A
/// component along an edge reduces the gap; other errors hardly matter.
inline Vector square_to(Vector n, const Triangle& t, int edge) {
  for (int twice = 0; twice < 2; ++twice)
    n = n - (dot(n, t.edge[edge]) * t.inverse2[edge]) * t.edge[edge];
  return n;
}

/// Tries all directions of the separating-axis theorem, for pairs whose direction of closest points
/// is inaccurate, because these are close together compared with the size of the triangles. Rarely
/// needed, so it recomputes everything: the numbers of the fast path may then stay in registers.
[[gnu::noinline]] void search_axes(const TrianglePairs8& pairs, int first, Mask wanted,
                                   Separation& best) {
  Pairs p;
  p.a.load(pairs.a, first), p.b.load(pairs.b, first);
  p.a.turn(), p.b.turn();
  p.set_differences();
  Face a, b;
  set_faces(p, a, b);
  const Vector nearest = best.normal;
  best.offer(a.normal, p, wanted);
  best.offer(b.normal, p, wanted);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vector product = cross(p.a.edge[i], p.b.edge[j]);
      best.offer(square_to(square_to(product, p.b, j), p.a, i), p, wanted);
      best.offer(square_to(square_to(nearest, p.b, j), p.a, i), p, wanted);
    }
    best.offer(cross(p.a.edge[i], a.normal), p, wanted);
    best.offer(cross(p.b.edge[i], b.normal), p, wanted);
    best.offer(square_to(nearest, p.a, i), p, wanted);
    best.offer(square_to(nearest, p.b, i), p, wanted);
  }
}

inline void store_points(const Pairs& p, const Best& best, Mask meet, int first,
                         ClosestPoints8& out) {
  Vector corner = p.a.v[0], edge = p.a.edge[0];
  for (int i = 1; i < 6; ++i) {
    const Mask here = best.anchor == broadcast(i);
    corner = select(here, i < 3 ? p.a.v[i] : p.b.v[i - 3], corner);
    edge = select(here, i < 3 ? p.a.edge[i] : p.b.edge[i - 3], edge);
  }
  const Vector point = corner + best.along * edge;
  const Mask of_b = best.anchor > broadcast(2.5);
  const Vector apart = select(meet, Vector{}, best.apart);
  store(out.a, first, select(of_b, point + apart, point));
  store(out.b, first, select(of_b, point, point - apart));
}

inline void store_results(const TrianglePairs8& pairs, const Pairs& p, const Best& best,
                          Mask beyond, int first, ClosestPoints8& out) {
  const Mask meet = best.squared < broadcast(least_square);
  store_points(p, best, meet, first, out);
  const Number distance = select(meet, Number{}, root(best.squared));
  Separation apart;
  apart.normal = (broadcast(1) / select(meet, broadcast(1), distance)) * best.apart;
  apart.gap = Shadow(apart.normal, p.r[0][0], p.a, p.b).gap();
  const Mask turned = ~(meet | beyond) & (apart.gap < broadcast(0.999) * distance);
  if (any(turned)) {
    Separation better = apart;
    search_axes(pairs, first, turned, better);
    apart = better;
  }
  store(out.normal, first, apart.normal);
  store(out.gap + first, select(meet, Number{}, apart.gap));
  store(out.distance + first, select(beyond, broadcast(infinity), distance));
}

inline void one_pass(const TrianglePairs8& pairs, int first, int count, double limit,
                     ClosestPoints8& out) {
  Pairs p;
  p.a.load(pairs.a, first), p.b.load(pairs.b, first);
  const Vector r00 = p.a.v[0] - p.b.v[0];
  const Number size2 =
      dot(r00, r00) + p.a.length2[0] + p.a.length2[2] + p.b.length2[0] + p.b.length2[2];
  // The square of the limit plus rounding: (l + m)² ≤ (1 + 1e-6) l² + (1 + 1e6) m², where m is far
  // above the rounding errors of heights and gaps.
  const Number reach2 = broadcast(1.000001 * limit * limit) + broadcast(1e-22) * size2;
  // Unused lanes count as far away, so that they cause no work.
  Mask beyond = far_apart(p.a, p.b, r00, reach2) | (lane_numbers() >= broadcast(count - first));
  if (!any(~beyond)) return store(out.distance + first, broadcast(infinity));
  p.a.turn(), p.b.turn();
  p.set_differences();
  Face a, b;
  set_faces(p, a, b);
  beyond |= a.beyond(reach2) | b.beyond(reach2);
  if (!any(~beyond)) return store(out.distance + first, broadcast(infinity));
  Best best;
  best.clear();
  const Mask straddle = ~(beyond | a.on_one_side() | b.on_one_side());
  if (any(straddle)) offer_piercing(a, b, straddle, best);
  offer_edges(p, best);
  offer_corners(a, 3, best), offer_corners(b, 0, best);
  store_results(pairs, p, best, beyond, first, out);
}

}  // namespace
}  // namespace sonde::lanes

namespace sonde {

template <>
void closest_points_in_lanes<SONDE_LANES>(const TrianglePairs8& pairs, int count, double limit,
                                          ClosestPoints8& out) {
  for (int first = 0; first < count; first += SONDE_LANES)
    lanes::one_pass(pairs, first, count, limit, out);
}

}  // namespace sonde
SONDE_LANES_END
