// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "engine/geometry/pose.hpp"

namespace sonde::ui {

/// A pose as in a file of poses: the header px,py,pz,qw,qx,qy,qz and a row with 17 digits, metres.
std::string pose_text(const Pose& pose);

/// A pose as a matrix of four rows and columns in NumPy's form, np.array([[...], ...]), with 17
/// digits, metres.
std::string matrix_text(const Pose& pose);

/// Parses a pose: seven numbers, separated by commas or spaces, with or without that header or
/// brackets around them; or the 16 or 12 numbers of a matrix, row by row, as NumPy prints and
/// writes it. Throws std::invalid_argument with the reason.
Pose pose_in(std::string_view text);

/// The rotation as roll, pitch and yaw (rad): about the fixed x, then y, then z. Pitch is within a
/// quarter turn.
Vec3 roll_pitch_yaw(const Quat& q);
Quat of_roll_pitch_yaw(const Vec3& angles);

}  // namespace sonde::ui
