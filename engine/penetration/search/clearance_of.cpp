// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/clearance_of.hpp"

#include "engine/proximity/queries/distance.hpp"

namespace sonde {
namespace {

/// m: the square of a larger distance may not be finite. Bodies extend to at most 1e30 m, so at
/// such a distance they are points, to rounding.
constexpr double as_points = 1e150;

}  // namespace

Clearance clearance_of(const Body& probe, const Body& fixed, const Pose& X_FM, bool overlapping) {
  if (X_FM.p.cwiseAbs().maxCoeff() > as_points) {
    const Vec3 a = X_FM * surface(probe).vertices.front(), b = surface(fixed).vertices.front();
    return {(a - b).stableNorm(), a, b, false};
  }
  const Distance d = triangle_distance(probe, fixed, Transform(X_FM));
  return {overlapping ? 0 : d.distance, d.on_a, d.on_b, overlapping};
}

}  // namespace sonde
