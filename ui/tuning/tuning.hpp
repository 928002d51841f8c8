// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
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
  QString doubt = {};  ///< why it is not about the pair that is open; empty where it is
  /// The finished rows (parts of the study), and how many there will be.
  std::size_t rows = 0, of_rows = 0;
  bool computed = false;  ///< here, and in no folder of the user's yet
  bool finished() const { return rows == of_rows; }
};

/// Whether a connected device calls itself as the device that a map is of: an arm that says
/// "sigma.7 right-handed" is a sigma.7, but a "Touch X" no Touch, if `known` has the id of one.
bool is_named_in(const TuningResults& results, const QString& connected,
                 std::span<const std::string> known);

/// Reads a folder, or the folder of a file, for an open pair. Throws InputError naming what is
/// missing or broken.
Tuning load_tuning(const std::filesystem::path& folder_or_file, const LoadedScene& opened);

/// The situations that can be studied alone, by their kinds.
std::vector<std::string> situation_kinds();

/// The computation: the gains of the open pair, on a device.
struct TuningOrder {
  /// A study's own folder is made in it, by what the study depends on: the same order goes on where
  /// it was stopped.
  std::filesystem::path within;
  DeviceProfile device;
  Coupling::Mode mode = Coupling::Mode::object;
  std::string kind;  ///< of the situations; empty: all
};

/// The folder of studies that nobody has saved: studies/ in the user's folder for Sonde's data.
std::filesystem::path computed_studies_folder();

/// Computes as `sonde tune` does, with its files, on all processors but one, which the servo has.
/// `found` gets what is finished after each row, from any thread, one at a time. Keeps the newest
/// few studies of the folder. Throws InputError, and Cancelled where `progress` cancels: finished
/// rows stay in the folder.
Tuning compute_tuning(const TuningOrder& order, const LoadedScene& opened, const Progress& progress,
                      const std::function<void(const Tuning&)>& found = {});

/// Writes a finished tuning to a folder, as `sonde tune` does. Throws InputError where that holds
/// something else, or cannot be written.
void save_tuning(const Tuning& tuning, const std::filesystem::path& folder);

}  // namespace sonde::ui
