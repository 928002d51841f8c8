// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/file_unit.hpp"

#include <algorithm>

namespace sonde {
namespace {

constexpr FileUnit units[] = {{"m", "metres", 1},          {"cm", "centimetres", 1e-2},
                              {"mm", "millimetres", 1e-3}, {"um", "micrometres", 1e-6},
                              {"in", "inches", 0.0254},    {"ft", "feet", 0.3048}};

}  // namespace

std::span<const FileUnit> file_units() { return units; }

std::vector<std::string> file_unit_names() {
  std::vector<std::string> out;
  for (const FileUnit& unit : units) out.emplace_back(unit.name);
  return out;
}

std::optional<double> unit_in_metres(std::string_view name) {
  const auto* const found = std::ranges::find(units, name, &FileUnit::name);
  return found == std::end(units) ? std::nullopt : std::optional(found->metres);
}

std::optional<std::string> unit_name(double metres) {
  const auto* const found = std::ranges::find(units, metres, &FileUnit::metres);
  return found == std::end(units) ? std::nullopt : std::optional(std::string(found->name));
}

}  // namespace sonde
