// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// How much force a metre of a contact's multiplier is in a wrench, N/m: contact i carries this
/// times λᵢ along its normal. At the optimum the displacement of the centre of mass is Σ λᵢ nᵢ, and
/// a coupling pulls along it, so the forces of all clusters add up to that of the wrench (but for
/// damping). Where opposed contacts carry a torque alone, it is that of the torque, about the
/// probe's centre of mass `com` (fixed frame, m). 0 where nothing is carried.
double force_per_multiplier(const Wrench& wrench, const ContactClusters& clusters, const Vec3& com);

}  // namespace sonde
