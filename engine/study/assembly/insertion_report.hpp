// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/assembly/insertion_map.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde {

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
