// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "engine/geometry/pose.hpp"

namespace sonde {

struct TimedPose {
  double t = 0;  ///< s
  Pose pose;     ///< X_FM: the probe's mesh frame in the fixed body's mesh frame
};

/// Reads `px,py,pz,qw,qx,qy,qz`. Throws InputError with file, line and reason: a wrong header, a
/// wrong column count, a field that is not a finite number, or a quaternion whose length differs
/// from 1 by more than 1e-3 (others are normalised).
std::vector<Pose> read_poses(const std::filesystem::path& file);
/// The same, or a path with `t` as the first column, which is ignored.
std::vector<Pose> read_poses_or_path(const std::filesystem::path& file);

/// Reads `t,px,py,pz,qw,qx,qy,qz`, t strictly increasing; errors as for read_poses.
std::vector<TimedPose> read_trajectory(const std::filesystem::path& file);

}  // namespace sonde
