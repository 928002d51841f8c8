// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/assembly/insertion.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// A map of how a part may be off at the mouth and still go in: offsets along one direction, and
/// tilts in the plane of this and the axis, each about the centre of mass, both from less than zero
/// to their largest.
struct InsertionMap {
  Vec3 axis = Vec3::UnitZ(), lateral = Vec3::UnitX();  ///< F, unit, square to each other
  double largest_offset = 0;                           ///< m
  double largest_tilt = 0;                             ///< rad
  std::size_t offsets = 1, tilts = 1;                  ///< how many of each; odd: 0 is among them
};

/// What a study of an insertion is made of.
struct InsertionRequest {
  Pair pair;
  InsertionWay way;
  std::size_t steps = 200;
  Coupling coupling;
  double wanted = 0;                ///< m of travel that count as in
  std::optional<InsertionMap> map;  ///< only of ways along an axis
  std::string about;                ///< JSON text: inputs and settings
};

/// The parts: the way, and a row of the map for each offset.
Study plan_insertion(const InsertionRequest& request);

/// The final files, from the parts alone: `insert.csv` and `insert.svg` along the way, `map.csv`
/// and `map.svg`, `summary.json` and `summary.md`. Throws InputError, naming the folder, where a
/// part is missing or was not written by a study.
std::vector<StudyFile> insertion_files(const std::string& folder, const StudyFolder& study);

}  // namespace sonde
