// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "engine/calibration/calibration.hpp"
#include "engine/penetration/search/pair.hpp"
#include "tests/reference/depths_file.hpp"

namespace sonde::reference {

/// What limits of time cost on the poses of one pair of depths.csv, of both methods, beside the
/// depths committed there.
Calibration calibrate_rows(const Pair& pair, const std::string& name, std::span<const Row> rows);

}  // namespace sonde::reference
