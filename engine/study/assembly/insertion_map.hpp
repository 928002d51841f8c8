// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/study/assembly/insertion.hpp"

namespace sonde {

/// A map of the misalignments at the mouth with which a part still goes in: offsets along one
/// direction, and tilts about the centre of mass in the plane of this direction and the axis, both
/// from minus their largest value to plus that.
struct InsertionMap {
  Vec3 axis = Vec3::UnitZ(), lateral = Vec3::UnitX();  ///< F, unit, orthogonal
  double largest_offset = 0;                           ///< m
  double largest_tilt = 0;                             ///< rad
  std::size_t offsets = 1, tilts = 1;                  ///< number of each; if odd, 0 is one of them

  double offset(std::size_t i) const;  ///< m
  double tilt(std::size_t j) const;    ///< rad
};

/// A direction perpendicular to the axis, in the coordinate in which the axis is smallest. Both
/// unit.
Vec3 lateral_to(const Vec3& axis);

/// What of a direction is square to that axis (unit): unit, or none where the direction lies along
/// the axis or is none.
std::optional<Vec3> square_to(const Vec3& axis, const Vec3& direction);

/// A way moved aside and tilted about the centre of mass where it begins.
InsertionPath moved(const InsertionPath& way, const Pair& pair, const InsertionMap& map,
                    double offset, double tilt);

/// m: travel that is free; negative if the path begins in an overlap. Throws Cancelled.
double free_travel(const Pair& pair, const InsertionPath& way, const Progress& progress = {});

/// The free travel at every point of a map, m, row by row for each offset. Throws InputError if a
/// range is not finite or negative, or there are no points; and Cancelled.
std::vector<double> free_travels(const Pair& pair, const InsertionPath& way,
                                 const InsertionMap& map, unsigned threads,
                                 const Progress& progress = {});

}  // namespace sonde
