// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "engine/study/tuning/tuning_results.hpp"

namespace sonde {

/// What a map shows of one run, worst first.
enum class MapClass { unstable, saturated, chattering, stable, passive };
const char* name_of(MapClass map_class);
/// Passive: stable, and below the stiffness that theory has passive.
MapClass class_of(const SweepPoint& run, double passive);

/// Every run of the study, a row each. The header names the columns; units are SI.
std::string map_csv(const TuningResults& results);

/// The map as a picture. For the object norm a row for each situation and hand over the stiffness;
/// for the classic coupling a panel for all gains together and for each axis alone, stiffness by
/// damping, with the worst of all situations. The limits that were measured and those of theory are
/// drawn in. Below it: how far the wrench is from Hooke's law.
std::string map_svg(const TuningResults& results);

}  // namespace sonde
