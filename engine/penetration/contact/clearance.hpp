// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde {

/// The distance of two bodies and their closest points, in the fixed body's mesh frame, metres.
struct Clearance {
  double distance = 0;           ///< least distance of the bodies, m; 0 if they overlap
  Vec3 on_probe = Vec3::Zero();  ///< the closest point on A
  Vec3 on_fixed = Vec3::Zero();  ///< the closest point on B
  /// The bodies touch or overlap, by exact predicates. The points are then on both surfaces where
  /// these meet, or the closest points of the surfaces if one body lies within the other.
  bool overlapping = false;
};

}  // namespace sonde
