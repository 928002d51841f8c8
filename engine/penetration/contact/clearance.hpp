// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde {

/// How far two bodies are apart, and where: points in the fixed body's mesh frame, metres.
struct Clearance {
  double distance = 0;           ///< the least distance of the two, m; 0 where they overlap
  Vec3 on_probe = Vec3::Zero();  ///< the point of A where it is taken
  Vec3 on_fixed = Vec3::Zero();  ///< the point of B
  /// They touch or overlap, by exact predicates. The points are then on both surfaces where these
  /// meet, and nearest points of the surfaces where one body lies within the other.
  bool overlapping = false;
};

}  // namespace sonde
