// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The answer at a pose at which the bodies only touch: the nearest free pose by the contacts
/// there, with these contacts and a depth at the level of rounding
/// (TouchingTuning::level_in_roundings). The pose is free by the exact test. A search could not
/// find a better answer, since that depth is 0 to rounding. The caller sets the lower bound. No
/// value if the bodies overlap by more, or if no motion that small frees the probe, as for a peg
/// exactly as large as its hole; finding that out costs a few µs. Allocates.
/// @pre The bodies overlap at X_FM, whose quaternion is unit.
std::optional<Separation> touching_separation(const Body& probe, const Body& fixed,
                                              const Pose& X_FM, Method method);

/// For a free pose that touches the fixed body within rounding: a pose close by whose contacts have
/// the least gap that a descent keeps, free by the exact test. (A sweep that begins with smaller
/// gaps cannot distinguish the contacts from overlaps, and stops at once in any direction.) No
/// value if all gaps are that large already, or if no small motion makes them so, as for a peg
/// exactly as large as its hole. Allocates.
/// @pre The bodies do not overlap at X_FM, whose quaternion is unit.
std::optional<Pose> lifted_off(const Body& probe, const Body& fixed, const Pose& X_FM,
                               Method method);

}  // namespace sonde
