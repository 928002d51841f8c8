// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/study/tuning/tuning_results.hpp"

namespace sonde {

/// The class of one run in a map, worst first.
enum class MapClass { unstable, saturated, chattering, stable, passive };
const char* name_of(MapClass map_class);
/// Passive: stable, and below the theoretical passivity limit.
MapClass class_of(const SweepPoint& run, double passive);

/// Every run of the study, one row each. The header names the columns; units are SI.
std::string map_csv(const TuningResults& results);

/// The map as a picture. For the object norm it has a row for each situation and hand, over the
/// stiffness. For the classic coupling it has a panel for all gains together and for each axis
/// alone, stiffness against damping, with the worst of all situations. It shows the measured and
/// the theoretical limits, and below them the error of the wrench relative to the command.
std::string map_svg(const TuningResults& results);

}  // namespace sonde
