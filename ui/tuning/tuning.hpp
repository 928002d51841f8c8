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

/// The result of `sonde tune`, as a folder holds it.
struct Tuning {
  std::filesystem::path folder;
  TuningResults results;
  QString doubt;  ///< why it is not about the pair that is open; empty where it is
};

/// Reads a folder, or the folder of a file, for an open pair. Throws InputError naming what is
/// missing or broken.
Tuning load_tuning(const std::filesystem::path& folder_or_file, const LoadedScene& opened);

/// The situations that can be studied alone, by their kinds.
std::vector<std::string> situation_kinds();

/// The computation: the gains of the open pair, on a device.
struct TuningOrder {
  std::filesystem::path folder;  ///< what is finished there is taken over
  DeviceProfile device;
  Coupling::Mode mode = Coupling::Mode::object;
  std::string kind;  ///< of the situations; empty: all
};

/// Computes as `sonde tune` does, with its files. Throws InputError, and Cancelled where `progress`
/// cancels: finished parts stay in the folder.
Tuning compute_tuning(const TuningOrder& order, const LoadedScene& opened,
                      const Progress& progress);

}  // namespace sonde::ui
