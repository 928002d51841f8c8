// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "engine/haptics/hand/hand.hpp"
#include "engine/scene/poses.hpp"

namespace sonde {

/// The pose of a path at a time, interpolated on a straight line and with a turn about one axis;
/// before the first and after the last pose, that pose. The path must not be empty.
Pose pose_at(std::span<const TimedPose> path, double t) noexcept;

/// A recorded path that holds the probe. It moves the probe from its present pose to the path's
/// first pose within a second, then along the path at the recorded speed, and stays at its end.
class PathHand {
 public:
  /// Throws std::invalid_argument for a path without poses.
  PathHand(std::vector<TimedPose> path, const Pose& X_FM);
  PathHand(const PathHand&) = delete;
  PathHand& operator=(const PathHand&) = delete;

  /// Functions for the servo; this object must outlive it.
  Hand hand();

 private:
  std::vector<TimedPose> path_;
  double t_;
};

}  // namespace sonde
