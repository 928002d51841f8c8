// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "engine/text/number_text.hpp"

namespace sonde {

/// A length (m) as text, in the unit with the fewest zeros: "10 µm", "2.5 mm", "1.2 m".
inline std::string length_text(double metres, int digits = 6) {
  constexpr std::array<std::pair<double, const char*>, 4> units{
      {{1, "m"}, {1e-3, "mm"}, {1e-6, "µm"}, {1e-9, "nm"}}};
  for (const auto& [size, name] : units)
    if (std::abs(metres) >= size * (1 - 1e-12))
      return number_text(metres / size, digits) + " " + name;
  return number_text(metres, digits) + " m";
}

}  // namespace sonde
