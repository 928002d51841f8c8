// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace sonde::ui {

/// What stands below the force in the view.
struct ForceNote {
  QString text;  ///< the gains felt where those set wait, and what a study says; empty: nothing
  QString now;   ///< what is wrong now, as measured in the last second; empty: nothing
  /// |F| of the last ticks, N, the oldest first: what a picture sixty times a second cannot show.
  /// Empty: not drawn.
  std::vector<double> course;
  bool operator==(const ForceNote&) const = default;
};

}  // namespace sonde::ui
