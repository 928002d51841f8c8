// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "ui/export/moment.hpp"

namespace sonde::ui {

/// A row for each moment, the unit of each column in its name: pose of the probe, separated pose,
/// depth, force, torque.
std::string moments_csv(std::span<const Moment> moments);

/// A row for each cluster of contacts at each moment: its id, its share of the force, multiplier,
/// gap, points, normal and number of rows.
std::string contacts_csv(std::span<const Moment> moments);

/// The table of contacts that goes with a table of moments: NAME.contacts.csv beside NAME.csv.
std::filesystem::path contacts_file_of(const std::filesystem::path& file);

/// Writes both tables, or neither. Throws InputError, and Cancelled where `progress` says so.
void write_tables(const std::filesystem::path& file, std::string_view moments,
                  std::string_view contacts, const std::function<bool(double)>& progress = {});

}  // namespace sonde::ui
