// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// Force per metre of a contact's multiplier in a wrench, N/m: contact i carries this times λᵢ
/// along its normal. At the optimum the displacement of the centre of mass is Σ λᵢ nᵢ, and a
/// coupling pulls along it, so the forces of all clusters add up to that of the wrench (except for
/// damping). If opposed contacts carry only a torque, the factor is computed from the torque about
/// the probe's centre of mass `com` (fixed frame, m). 0 if the contacts carry nothing.
double force_per_multiplier(const Wrench& wrench, const ContactClusters& clusters, const Vec3& com);

}  // namespace sonde
