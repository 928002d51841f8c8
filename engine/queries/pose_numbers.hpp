// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// The pose of px, py, pz, qw, qx, qy, qz, with the quaternion normalised. Throws
/// std::invalid_argument, with the reason, if a number is not finite or the quaternion's length
/// differs from 1 by more than 1e-3.
Pose pose_of_numbers(std::span<const double, 7> numbers);

}  // namespace sonde
