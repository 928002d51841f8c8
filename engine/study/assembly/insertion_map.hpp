// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/study/assembly/insertion.hpp"

namespace sonde {

/// A map of how a part may be off at the mouth and still go in: offsets along one direction, and
/// tilts in the plane of this and the axis, each about the centre of mass, both from less than zero
/// to their largest.
struct InsertionMap {
  Vec3 axis = Vec3::UnitZ(), lateral = Vec3::UnitX();  ///< F, unit, square to each other
  double largest_offset = 0;                           ///< m
  double largest_tilt = 0;                             ///< rad
  std::size_t offsets = 1, tilts = 1;                  ///< how many of each; odd: 0 is among them

  double offset(std::size_t i) const;  ///< m
  double tilt(std::size_t j) const;    ///< rad
};

/// A direction square to that axis, along the coordinate that it has least of. Both unit.
Vec3 lateral_to(const Vec3& axis);

/// What of a direction is square to that axis (unit): unit, or none where the direction lies along
/// the axis or is none.
std::optional<Vec3> square_to(const Vec3& axis, const Vec3& direction);

/// A way moved aside and tilted about the centre of mass where it begins.
InsertionWay moved(const InsertionWay& way, const Pair& pair, const InsertionMap& map,
                   double offset, double tilt);

/// m of travel that are free; less than 0 where the way begins in an overlap.
double free_travel(const Pair& pair, const InsertionWay& way);

/// The free travel at every point of a map, m, those of one offset side by side. Throws InputError
/// where a range is not finite or less than 0, or there are no points; and Cancelled.
std::vector<double> free_travels(const Pair& pair, const InsertionWay& way, const InsertionMap& map,
                                 unsigned threads, const Progress& progress = {});

}  // namespace sonde
