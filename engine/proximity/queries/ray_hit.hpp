// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "engine/body/body.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

struct RayHit {
  double distance = 0;  ///< along the direction, m
  std::uint32_t triangle = 0;
};

/// The first point at which a ray meets the triangles of a soup, from either side, among the points
/// that the filter `counts` accepts (all without a filter). Everything is in the soup's frame; the
/// direction is a unit vector. It tests every triangle, so it is for a user's click, not for a
/// tick.
std::optional<RayHit> ray_hit(const Soup& soup, const Vec3& from, const Vec3& direction,
                              const std::function<bool(const Vec3&)>& counts = {});

/// The first point at which a ray meets a body's surface (triangles of surface(body)), from either
/// side, with its tree. Triangles within the material (is_covered) do not count. Never allocates.
std::optional<RayHit> first_hit(const Body& body, const Vec3& from, const Vec3& direction);

}  // namespace sonde
