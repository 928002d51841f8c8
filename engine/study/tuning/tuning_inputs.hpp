// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "engine/body/body.hpp"

namespace sonde {

/// The files that a study of gains is of.
struct TuningFiles {
  std::filesystem::path probe, fixed;
  std::filesystem::path trajectory;  ///< empty: none
};

/// TuningRequest::inputs: JSON that tells files and programs apart. Whoever asks for the same study
/// says the same, so that one goes on with what another began; all else that a study depends on is
/// in its request. Throws InputError where a file cannot be read.
std::string tuning_inputs(const std::string& version, const TuningFiles& files, const Body& probe,
                          const Body& fixed);

}  // namespace sonde
