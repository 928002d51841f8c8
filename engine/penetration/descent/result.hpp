// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/penetration/descent/descent.hpp"

namespace sonde {

/// Why a pose cannot be computed with, static text: a number is not finite, or the quaternion has
/// no length or one whose square is not finite. Null if it can.
const char* fault_of(const Pose& X) noexcept;
inline bool is_finite(const Pose& X) noexcept { return fault_of(X) == nullptr; }

/// A failed answer for the pose O; the reason is static text.
Separation failed(const Pose& device, const char* reason) noexcept;

/// The answer that the probe is free where it is.
Separation separated_at(const Pose& device) noexcept;

/// The result of a descent as an answer. A probe that came all the way back to O is separated.
Separation make_separation(const Chart& chart, const Descent::Outcome& found) noexcept;

}  // namespace sonde
