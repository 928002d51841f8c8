// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "engine/calibration/calibration.hpp"

namespace sonde {

/// A calibration as JSON: {"calibration": 1, "program": VERSION, "series": [{"pair", "answers",
/// "method", "sketched", "points": [{"time_us", "errors"}]}]}, errors ascending, null for a
/// failure.
std::string to_json(const Calibration& calibration);

/// Parses such a text. Throws InputError with the file, the line and the reason: a truncated text
/// or no JSON, another version of the format, an unknown or missing key, or times or errors that
/// are negative or out of order.
Calibration calibration_in(const std::string& text, const std::filesystem::path& file);
Calibration read_calibration(const std::filesystem::path& file);

/// The calibration included in the build (resources/calibration.json), measured on the pairs of
/// tests/reference/pairs.cpp, the scenes of tests/reference/surfaces and the bundled scenes' paths.
const Calibration& default_calibration();

}  // namespace sonde
