// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/mass.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {

/// Constants for the mass of overlapping parts, which is computed with parallel lines in three
/// directions.
struct OverlapTuning {
  int first_look = 64;               ///< lines along a side, to decide whether anything overlaps
  int rasters[2] = {256, 512};       ///< that integrate; the error that is said comes from both
  int local_rasters[2] = {64, 128};  ///< the same, through a place where parts cross
  /// Share of the size: overlap over less of a line is rounding, where faces lie on each other.
  double rounding = 1e-9;
  /// Share of the volume: with less overlap, the sum over the triangles is used, to its last
  /// digits.
  double least = 1e-7;
  double most_differ = 0.1;  ///< share of the volume: where the rasters differ by more it counts
                             ///< as unknown, and the body as a surface
};
inline constexpr OverlapTuning overlap_tuning;

/// The region in which the winding number is not 0, prepared for integration.
struct Region {
  Soup soup;         ///< a sum over these triangles, in which parts may count 0 or -1 times
  MassMoments more;  ///< contribution of the lines, where parts cross
  bool overlaps = false;
  double error = 0;   ///< of `more`, relative to the volume; 0 if the sum is exact
  double differ = 0;  ///< what the two rasters differ by, relative to the volume
  /// Parts cross in more places than can be looked at: how far the mass is off is not known.
  bool unknown = false;
  /// If no two parts cross: the parts that lie entirely inside, and without which the region is the
  /// same. Empty if there is none.
  std::vector<bool> hidden;
};

/// The region of closed parts. If no two parts cross, each one bounds the region everywhere or
/// nowhere, and the sum over those that do is exact. Otherwise (winding number ≠ 0) − (winding
/// number) is integrated along lines. Returns an empty soup if no line meets winding numbers other
/// than 0 and 1 over more than the rounding, neither of some through all nor of those through the
/// places where parts cross each other or themselves: then the sum over all triangles is correct,
/// unless that is unknown. Throws Cancelled.
Region find_region(const Soup& soup, const std::vector<std::uint32_t>& part,
                   const Progress& progress = {});

/// The mass of the region bounded by closed triangles, given their parts.
MassProperties mass_of(const Region& region, const Progress& progress = {});

}  // namespace sonde
