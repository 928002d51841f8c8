// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/effort.hpp"
#include "engine/body/body.hpp"

namespace sonde {

/// No point of the probe is further than this from where it is at the other pose, m.
double farthest_move(const MassProperties& mass, const Pose& from, const Pose& to);

/// What is known of the room around a free pose of the probe. As long as no point of it has moved
/// by more than a part of that room, it is free, and so is the way there, with no look at the
/// bodies. Never allocates.
class FarApart {
 public:
  FarApart(const Body& probe, const Body& fixed) noexcept : probe_(probe), fixed_(fixed) {}

  /// What comes next has nothing to do with what was before.
  void forget() noexcept { used_up_at_ = 0, wait_ = 0, next_wait_ = 1, asked_ = 16; }

  /// Is the probe free at X_FM, and on the way there from any other such pose? True only where
  /// that is certain. Reads no triangle.
  bool covers(const Pose& X_FM) const noexcept;

  /// The probe is free at X_FM, and last moved by so much (m, its farthest point): looks for the
  /// room there is for some tens of such moves. Does nothing where looks did not pay of late.
  void look(const Pose& X_FM, double last_move, Effort& effort) noexcept;

 private:
  const Body& probe_;
  const Body& fixed_;
  Pose centre_;
  double used_up_at_ = 0;  ///< m; 0: nothing is known
  int wait_ = 0;           ///< ticks until the next look
  int next_wait_ = 1;
  double asked_ = 16;  ///< moves for which the next look asks for room
};

}  // namespace sonde
