// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <string>

namespace sonde::ui::test {

/// A torus as OFF text, of 2·n² triangles, m.
inline std::string torus(int n) {
  std::string text = "OFF\n" + std::to_string(n * n) + ' ' + std::to_string(2 * n * n) + " 0\n";
  const auto turn = [n](int i) { return 2 * std::numbers::pi * i / n; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double r = 0.1 + 0.035 * std::cos(turn(j));
      text += std::to_string(r * std::cos(turn(i))) + ' ' + std::to_string(r * std::sin(turn(i))) +
              ' ' + std::to_string(0.035 * std::sin(turn(j))) + '\n';
    }
  const auto at = [n](int i, int j) { return std::to_string((i % n) * n + j % n) + ' '; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      text += "3 " + at(i, j) + at(i + 1, j) + at(i + 1, j + 1) + '\n';
      text += "3 " + at(i, j) + at(i + 1, j + 1) + at(i, j + 1) + '\n';
    }
  return text;
}

}  // namespace sonde::ui::test
