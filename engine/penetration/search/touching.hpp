// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The answer at a pose at which the bodies only touch: the nearest free pose, as far as the
/// contacts there tell, with these contacts and a depth at the level of rounding
/// (TouchingTuning::level_in_roundings). It is free by the exact test, and a search could find no
/// answer that is told from it: none is less than 0 deep. The lower bound is left to the caller. No
/// value where the bodies overlap by more, or where no motion so small sets the probe free, as for
/// a peg that is exactly as large as its hole; that costs a few µs. Allocates.
/// @pre The bodies overlap at X_FM, whose quaternion is unit.
std::optional<Separation> touching_separation(const Body& probe, const Body& fixed,
                                              const Pose& X_FM, Method method);

}  // namespace sonde
