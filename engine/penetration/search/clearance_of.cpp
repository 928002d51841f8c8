// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/clearance_of.hpp"

#include "engine/proximity/queries/distance.hpp"

namespace sonde {

Clearance clearance_of(const Body& probe, const Body& fixed, const Pose& X_FM, bool overlapping) {
  const Distance d = triangle_distance(probe, fixed, Transform(X_FM));
  return {overlapping ? 0 : d.distance, d.on_a, d.on_b, overlapping};
}

}  // namespace sonde
