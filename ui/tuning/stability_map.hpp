// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "engine/study/tuning/tuning_map.hpp"

namespace sonde::ui {

/// A row of the map. Stiffness in N/m or N·m/rad, damping in N·s/m or N·m·s/rad, by the axis.
struct MapRow {
  struct Stretch {
    double from, to;  ///< stiffness
    MapClass map_class;
  };
  double from = 0, to = 1;  ///< its place along y
  double damping = 0;
  QString label;                                 ///< of a row that is no damping
  std::string kind;                              ///< of the contact; the same
  std::vector<Stretch> stretches;                ///< from below, without gaps
  double stable = 0;                             ///< the measured limit
  double theory_stable = 0, theory_passive = 0;  ///< infinite where theory sees no end
};

/// The result of a study over the gains of one axis: over damping and stiffness where it varied
/// both, else a row for each situation and hand.
struct StabilityMap {
  GainAxis axis = GainAxis::object;
  bool over_damping = false;
  std::vector<MapRow> rows;
  double low = 1, high = 1e5;  ///< stiffness at the ends
};

/// For the unchanged profile, in situations of one kind or (empty) of every kind. A row that stands
/// for several situations and hands shows the worst of them, and the least of each limit.
StabilityMap stability_map(const TuningResults& results, GainAxis axis, const std::string& kind);

/// Gains as a place on a map.
struct MapPoint {
  double stiffness = 0;
  double damping = 0;
  bool operator==(const MapPoint&) const = default;
};
MapPoint point_of(const Coupling& gains, GainAxis axis);

/// The kinds of situations studied, in their order.
std::vector<std::string> kinds_of(const TuningResults& results);

/// "N/m", "N·m/rad"; "N·s/m", "N·m·s/rad".
QString stiffness_unit(GainAxis axis);
QString damping_unit(GainAxis axis);

}  // namespace sonde::ui
