// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>
#include <vector>

namespace sonde::ui {

/// A file or folder of the program's resources, in ../share/sonde beside the program: installed
/// there, or a link to the source tree. Empty where there is none.
QString resource(const QString& name);

/// Where device profiles are looked for: the user's own (devices/ in the user's folder for Sonde's
/// data, ~/.local/share/sonde) before those that came with the program.
std::vector<std::filesystem::path> device_profile_folders();

/// Where the settings of devices are kept: devices/ in the user's folder for Sonde's settings,
/// ~/.config/sonde.
std::filesystem::path device_settings_folder();

}  // namespace sonde::ui
