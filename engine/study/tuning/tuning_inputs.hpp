// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "engine/body/body.hpp"

namespace sonde {

/// The input files of a study of gains.
struct TuningFiles {
  std::filesystem::path probe, fixed;
  std::filesystem::path trajectory;  ///< empty: none
};

/// TuningRequest::inputs: JSON that identifies files and programs. Two callers that request the
/// same study must give the same text, so that one continues the other's work; the request holds
/// everything else that a study depends on. Throws InputError if a file cannot be read.
std::string tuning_inputs(const std::string& version, const TuningFiles& files, const Body& probe,
                          const Body& fixed);

}  // namespace sonde
