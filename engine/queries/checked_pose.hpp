// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/base/error.hpp"
#include "engine/geometry/pose.hpp"

namespace sonde {

/// The pose with its quaternion scaled to length 1.
/// @throws InputError if a number is not finite, or if the square of the quaternion's length is 0,
/// subnormal or not finite.
Pose checked_pose(const Pose& X);

/// The same for a pose at an end of a motion.
/// @throws InputError also if a coordinate exceeds 1e150 m: the square of the motion's length may
/// then not be finite.
Pose checked_pose_of_motion(const Pose& X);

}  // namespace sonde
