// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// Closest points of two bodies, in B's mesh frame, metres.
struct Distance {
  double distance = 0;  ///< 0 if triangles meet, or if a component lies inside a solid
  Vec3 on_a = Vec3::Zero();
  Vec3 on_b = Vec3::Zero();
  std::uint32_t triangle_a = 0;
  std::uint32_t triangle_b = 0;
  bool overlapping = false;  ///< triangles meet, or a component lies inside a solid
};

/// The pair of triangles with which a search begins. The closest pair at the last pose makes the
/// search short.
struct DistanceHint {
  std::uint32_t triangle_a = 0;
  std::uint32_t triangle_b = 0;
};

/// Distance between the triangles of A, placed at X_BA, and those of B. Accurate to about 1e-14 of
/// the largest coordinate. Never allocates.
Distance triangle_distance(const Body& a, const Body& b, const Transform& X_BA,
                           std::optional<DistanceHint> hint = {});

/// As triangle_distance, but a component inside a solid counts as overlapping, at distance 0. The
/// closest points are still those of the triangles.
Distance distance(const Body& a, const Body& b, const Transform& X_BA,
                  std::optional<DistanceHint> hint = {});

}  // namespace sonde
