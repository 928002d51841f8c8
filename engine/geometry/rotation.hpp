// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// These replace Eigen's AngleAxis, slerp and angularDistance, which call the C library.
#include "engine/geometry/pose.hpp"

namespace sonde {

/// Axis times angle (rad, 0 to π) of a unit quaternion, the shorter way. Uses the arc tangent of
/// the half angle, so it is exact to rounding for the smallest angles and at π.
Vec3 rotation_vector(const Quat& q) noexcept;

/// The rotation about the vector's direction by its length (rad).
Quat rotation_by(const Vec3& vector) noexcept;

/// The rotation about a unit axis by an angle (rad).
Quat rotation_about(const Vec3& axis, double angle) noexcept;

/// Interpolates from `from` (part 0) to `to` (part 1) at a constant rate, the shorter way (slerp;
/// Shoemake, 1985).
Quat rotation_between(const Quat& from, const Quat& to, double part) noexcept;

/// The angle between two rotations, rad, 0 to π.
double angle_between(const Quat& q, const Quat& r) noexcept;

}  // namespace sonde
