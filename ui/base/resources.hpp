// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>
#include <vector>

namespace sonde::ui {

/// A file or folder of the program's resources, in ../share/sonde beside the program: the installed
/// one, or a link to the source tree. Empty where there is none.
QString resource(const QString& name);

/// The folders of device profiles, in the order of the search: the user's own (devices/ in the
/// user's folder for Sonde's data, ~/.local/share/sonde), then those that came with the program.
std::vector<std::filesystem::path> device_profile_folders();

/// The folder of device settings: devices/ in the user's folder for Sonde's settings,
/// ~/.config/sonde.
std::filesystem::path device_settings_folder();

}  // namespace sonde::ui
