// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/settings/device_profile.hpp"
#include "engine/study/tuning/tuning_results.hpp"
#include "ui/document/loaded_scene.hpp"

namespace sonde::ui {

/// The result of `sonde tune`, as it lies in a folder.
struct Tuning {
  std::filesystem::path folder;
  TuningResults results;
  QString doubt;  ///< why it is not about the pair that is open; empty where it is
};

/// Reads a folder, or the folder that a file lies in, for a pair that is open. Throws InputError
/// naming what is missing or broken.
Tuning load_tuning(const std::filesystem::path& folder_or_file, const LoadedScene& opened);

/// The situations that can be studied alone, by their kinds.
std::vector<std::string> situation_kinds();

/// What to compute: the gains of the open pair, on a device.
struct TuningOrder {
  std::filesystem::path folder;  ///< what is finished there is taken over
  DeviceProfile device;
  Coupling::Mode mode = Coupling::Mode::object;
  std::string kind;  ///< of the situations; empty: all
};

/// As `sonde tune` does, with its files. Throws InputError, Cancelled where `progress` says so:
/// what is finished stays in the folder.
Tuning compute_tuning(const TuningOrder& order, const LoadedScene& opened,
                      const Progress& progress);

}  // namespace sonde::ui
