// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde {

/// Axis times angle (rad, 0 to π) of a unit quaternion, the shorter way round: by the arc tangent
/// of the half angle, so exact to rounding for the smallest angles and at π.
Vec3 rotation_vector(const Quat& q) noexcept;

/// The rotation about the vector's direction by its length (rad).
Quat rotation_by(const Vec3& vector) noexcept;

}  // namespace sonde
