// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "engine/base/effort.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// A pair of triangles within reach of each other, in B's mesh frame, metres.
struct NearPair {
  Vec3 on_a;
  Vec3 on_b;
  Vec3 normal;  ///< unit, from B to A
  double gap;   ///< gap along the normal: the distance of the triangles, up to rounding
  std::uint32_t triangle_a;
  std::uint32_t triangle_b;
};

struct NearPairs {
  std::size_t count = 0;  ///< pairs written
  double reach = 0;       ///< every pair nearer than this was written; negative: unknown
};

/// Writes all pairs at a distance of at most `reach` to `out`, in traversal order. If they do not
/// fit, it drops the farther ones and returns the smaller reach within which all pairs were
/// written. It leaves out pairs that meet, because they have no normal. `out` must hold at least
/// two. Never allocates. If the effort runs out, it returns no pairs and an unknown reach.
NearPairs near_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                     std::span<NearPair> out, Effort& effort);
NearPairs near_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                     std::span<NearPair> out);

/// Keeps the nearer half of a full buffer and returns its size; `reach` becomes the gap of the
/// nearest one dropped.
std::size_t keep_nearer_half(std::span<NearPair> out, double& reach);

}  // namespace sonde
