// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "ui/export/moment.hpp"

namespace sonde::ui {

/// A row for each moment, the unit of each column in its name: pose of the probe, separated pose,
/// depth, force, torque.
std::string moments_csv(std::span<const Moment> moments);

/// A row for each contact of each moment: cluster, share of the force, multiplier, gap, points and
/// normal.
std::string contacts_csv(std::span<const Moment> moments);

/// The share of a contact in the sum of all multipliers; 0 where there are none.
double share_of_force(const Contact& contact, const ContactClusters& all);

}  // namespace sonde::ui
