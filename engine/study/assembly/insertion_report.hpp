// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/study/assembly/insertion_map.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// The input of a study of an insertion.
struct InsertionRequest {
  Pair pair;
  InsertionPath way;
  std::size_t steps = 200;
  Coupling coupling;
  double wanted = 0;                ///< m of travel that count as inserted
  std::optional<InsertionMap> map;  ///< only for paths along an axis
  std::string about;                ///< JSON text: inputs and settings
};

/// The parts: one for the path, and one for each offset of the map.
Study plan_insertion(const InsertionRequest& request);

/// The final files, from the parts only: `insert.csv` and `insert.svg` along the path, `map.csv`
/// and `map.svg`, `summary.json` and `summary.md`. Throws InputError, naming the folder, if a part
/// is missing or was not written by a study.
std::vector<StudyFile> insertion_files(const std::string& folder, const StudyFolder& study);

}  // namespace sonde
