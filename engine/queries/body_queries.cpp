// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/queries/body_queries.hpp"

#include <limits>

#include "engine/base/round_to_nearest.hpp"
#include "engine/body/body.hpp"
#include "engine/proximity/queries/covered.hpp"
#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/point_distance.hpp"
#include "engine/proximity/queries/ray_hit.hpp"

namespace sonde {
namespace {

constexpr double farthest = 1e30;  // the same limit as for a body's coordinates

void check(const Vec3& x, const char* what) {
  if (!x.allFinite()) throw InputError(std::string(what) + " is not finite");
  if (x.cwiseAbs().maxCoeff() > farthest) throw InputError(std::string(what) + " is beyond 1e30");
}

Vec3 normal_of(const Body& body, std::uint32_t triangle) {
  return area_normal(corners(surface(body), triangle)).stableNormalized();
}

}  // namespace

bool inside(const Body& body, const Vec3& x) {
  const RoundToNearest round_to_nearest;
  if (!x.allFinite()) throw InputError("the point is not finite");
  return body.solid && winds_around(body, x);
}

SurfacePoint nearest_point(const Body& body, const Vec3& x) {
  const RoundToNearest round_to_nearest;
  check(x, "the point");
  const NearestPoint found = nearest_outside(body, x);
  return {found.point, normal_of(body, found.triangle), found.distance};
}

std::string_view part_at(const Body& body, const Vec3& x) {
  const RoundToNearest round_to_nearest;
  check(x, "the point");
  std::string_view nearest = body.name;
  double least = std::numeric_limits<double>::infinity();
  for (const BodyPart& part : body.parts) {
    const double distance = point_distance(*part.body, inverse(part.X_BP) * x);
    if (distance < least) least = distance, nearest = part.name;
  }
  return nearest;
}

std::optional<SurfacePoint> ray(const Body& body, const Vec3& from, const Vec3& direction) {
  const RoundToNearest round_to_nearest;
  check(from, "the start of the ray");
  check(direction, "the direction of the ray");
  const Vec3 unit = direction.stableNormalized();
  if (!(unit.squaredNorm() > 0.5)) throw InputError("the direction of the ray has no length");
  const std::optional<RayHit> hit = first_hit(body, from, unit);
  if (!hit) return std::nullopt;
  return SurfacePoint{from + hit->distance * unit, normal_of(body, hit->triangle), hit->distance};
}

}  // namespace sonde
