// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/static_options.hpp"

namespace sonde {

/// Searches for the nearest free pose among those that the probe reaches from X_FM by sliding
/// perpendicular to the normal and, if `turning`, by turning about the normal
/// (separate_within.hpp).
/// @pre The bodies overlap, the normal is unit, and so is X_FM.q.
/// @throws Cancelled if `progress` returns false.
Separation planar_separation(const Pair& pair, const Pose& X_FM, const Vec3& normal_F, bool turning,
                             const StaticOptions& options, const Progress& progress = {});

}  // namespace sonde
