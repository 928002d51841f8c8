// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The answer at poses that need no search: one that is not finite, or so far away that rounding
/// makes nonsense of it, is refused; one at which the probe is clear of the fixed body, however far
/// away, or free by the exact test is separated as it is. Nothing where they overlap. The pose is
/// to have a unit quaternion where it is finite.
std::optional<Separation> trivial_separation(const Body& probe, const Body& fixed,
                                             const Pose& X_FM);

}  // namespace sonde
