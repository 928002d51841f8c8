// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "engine/geometry/soup.hpp"

namespace sonde {

struct RayHit {
  double distance = 0;  ///< along the direction, m
  std::uint32_t triangle = 0;
};

/// Where a ray first meets the triangles of a soup, from either side, of the places that count (all
/// where nothing is given). Everything is in the soup's frame; the direction is unit. It looks at
/// every triangle: for a person's click, not for a tick.
std::optional<RayHit> ray_hit(const Soup& soup, const Vec3& from, const Vec3& direction,
                              const std::function<bool(const Vec3&)>& counts = {});

}  // namespace sonde
