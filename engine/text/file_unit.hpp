// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sonde {

/// A unit that files may be in.
struct FileUnit {
  std::string_view name;    ///< in scenes and for --unit
  std::string_view plural;  ///< in sentences
  double metres;
};
/// m, cm, mm, um, in, ft.
std::span<const FileUnit> file_units();
std::vector<std::string> file_unit_names();

/// Metres per unit of that name; no value for anything else.
std::optional<double> unit_in_metres(std::string_view name);
/// The name of the unit of exactly this size.
std::optional<std::string> unit_name(double metres);

}  // namespace sonde
