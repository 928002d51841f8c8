// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "engine/base/effort.hpp"
#include "engine/body/body.hpp"

namespace sonde {

/// A pair of triangles within reach of each other, in B's mesh frame, metres.
struct NearPair {
  Vec3 on_a;
  Vec3 on_b;
  Vec3 normal;  ///< unit, from B to A
  double
      gap;  ///< separation of the two triangles along the normal (their distance, but for rounding)
  std::uint32_t triangle_a;
  std::uint32_t triangle_b;
};

struct NearPairs {
  std::size_t count = 0;  ///< pairs written
  double reach = 0;       ///< every pair nearer than this was written; negative: no statement
};

/// All pairs at a distance of at most `reach`, in the order of the walk, written to `out`; where
/// they do not fit, the farther ones are dropped and the reach returned is the smaller one that
/// holds. Pairs that meet are left out: they have no normal. `out` must hold at least two. Never
/// allocates. Where the effort runs out nothing is found and nothing stated.
NearPairs near_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                     std::span<NearPair> out, Effort& effort);
NearPairs near_pairs(const Body& a, const Body& b, const Transform& X_BA, double reach,
                     std::span<NearPair> out);

/// Keeps the nearer half of a full buffer and returns its size; `reach` becomes the gap of the
/// nearest one dropped.
std::size_t keep_nearer_half(std::span<NearPair> out, double& reach);

}  // namespace sonde
