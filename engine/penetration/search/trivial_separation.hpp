// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// Share of the probe's radius: if coordinates are rounded by more, contacts are meaningless.
inline constexpr double largest_rounding = 0.01;

/// The answer at poses that need no search; no value if the bodies overlap. A pose that is not
/// finite, or so far away that rounding makes it meaningless, fails. If the probe is clear of the
/// fixed body, however far away, or free by the exact test, it is separated as it is.
/// @pre A finite pose has a unit quaternion.
std::optional<Separation> trivial_separation(const Body& probe, const Body& fixed,
                                             const Pose& X_FM);

}  // namespace sonde
