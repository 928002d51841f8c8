// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"
#include "engine/penetration/contact/clearance.hpp"

namespace sonde {

/// The clearance of the probe at X_FM (q of length 1). `overlapping` says whether the bodies
/// overlap there, which the caller already knows.
Clearance clearance_of(const Body& probe, const Body& fixed, const Pose& X_FM, bool overlapping);

}  // namespace sonde
