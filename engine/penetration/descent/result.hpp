// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/penetration/descent/descent.hpp"

namespace sonde {

/// The reason why nothing can be computed with a pose, as static text: a number is not finite, or
/// the square of the quaternion's length is 0, subnormal or not finite. Null if the pose is valid.
const char* fault_of(const Pose& X) noexcept;
inline bool is_finite(const Pose& X) noexcept { return fault_of(X) == nullptr; }

/// A failed answer for the pose O; the reason is static text.
Separation failed(const Pose& device, const char* reason) noexcept;

/// The answer for a probe that is free at the device pose.
Separation separated_at(const Pose& device) noexcept;

/// Converts the result of a descent to an answer. If the probe reached O, its status is separated.
Separation make_separation(const Chart& chart, const Descent::Outcome& found) noexcept;

}  // namespace sonde
