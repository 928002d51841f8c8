// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "ui/export/exported_instant.hpp"

namespace sonde::ui {

/// A row for each instant, the unit of each column in its name: pose of the probe, separated pose,
/// depth, force, torque.
std::string instants_csv(std::span<const ExportedInstant> instants);

/// A row for each cluster of contacts at each instant: its id, its share of the force, multiplier,
/// gap, points, normal and number of rows.
std::string contacts_csv(std::span<const ExportedInstant> instants);

/// The table of contacts that goes with a table of instants: NAME.contacts.csv beside NAME.csv.
std::filesystem::path contacts_file_of(const std::filesystem::path& file);

/// Writes both tables, or neither. Throws InputError, and Cancelled where `progress` says so.
void write_tables(const std::filesystem::path& file, std::string_view instants,
                  std::string_view contacts, const std::function<bool(double)>& progress = {});

}  // namespace sonde::ui
