// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "ui/export/moment.hpp"

namespace sonde::ui {

/// A row for each moment, the unit of each column in its name: pose of the probe, separated pose,
/// depth, force, torque.
std::string moments_csv(std::span<const Moment> moments);

/// A row for each cluster of contacts at each moment: its id, its share of the force, multiplier,
/// gap, points, normal and number of rows.
std::string contacts_csv(std::span<const Moment> moments);

}  // namespace sonde::ui
