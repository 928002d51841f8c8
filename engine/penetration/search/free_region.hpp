// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/effort.hpp"
#include "engine/body/body.hpp"

namespace sonde {

/// Upper bound of the displacement of any point of the probe between two poses, m.
double farthest_move(const MassProperties& mass, const Pose& from, const Pose& to);

/// Stores the room around a free pose of the probe: a lower bound of the distance of the bodies
/// there. As long as no point of the probe has moved by more than a part of that room, the probe
/// and its path are free, and the bodies need not be examined. Never allocates.
class FreeRegion {
 public:
  FreeRegion(const Body& probe, const Body& fixed) noexcept : probe_(probe), fixed_(fixed) {}

  /// Call it before a pose that is unrelated to the previous ones.
  void forget() noexcept { used_up_at_ = 0, wait_ = 0, next_wait_ = 1, asked_ = 16; }

  /// Whether the probe is certainly free at X_FM, and on the path to it from any other pose for
  /// which this holds. Reads no triangle.
  bool covers(const Pose& X_FM) const noexcept;

  /// Call it with a free pose X_FM and the last motion (m, of the probe's farthest point). Measures
  /// whether there is room for some tens of such motions. After a call that found too little room,
  /// the next calls do nothing, for more and more ticks.
  void look(const Pose& X_FM, double last_move, Effort& effort) noexcept;

 private:
  const Body& probe_;
  const Body& fixed_;
  Pose centre_;
  double used_up_at_ = 0;  ///< m: motion up to which the probe is free; 0: unknown
  int wait_ = 0;           ///< ticks until the next measurement
  int next_wait_ = 1;
  double asked_ = 16;  ///< the next measurement asks for room for this many motions
};

}  // namespace sonde
