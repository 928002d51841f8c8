// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/mass.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {

/// How well the mass of overlapping parts is known. All by parallel lines in three directions.
struct OverlapTuning {
  int first_look = 64;  ///< lines along a side, which say whether anything overlaps
  int rasters[2] = {256,
                    512};  ///< that integrate; what the two differ by is the error that is said
  /// Of the size: along so little of a line, overlap is rounding where faces lie on each other.
  double rounding = 1e-9;
  /// Of the volume: less than this, the sum over the triangles stands, and so do its last digits.
  double least = 1e-7;
  double most_error = 0.1;  ///< of the volume: known no better, it is not known
};
inline constexpr OverlapTuning overlap_tuning;

/// The region in which the winding number is not 0, to be integrated.
struct Region {
  Soup soup;         ///< a sum over these triangles, in which parts may count 0 or -1 times
  MassMoments more;  ///< what lines add to it, where parts cross
  bool overlaps = false;
  double error = 0;  ///< of `more`, relative to the volume; 0 where the sum is exact
  /// By part, where no two cross: those that lie wholly inside, and without which the region is the
  /// same. Empty where there is none.
  std::vector<bool> hidden;
};

/// Of closed parts. Where no two parts cross, each bounds the region everywhere or nowhere, and the
/// sum over those that do is exact. Elsewhere (winding number ≠ 0) − (winding number) is integrated
/// along lines. Nothing (an empty soup) where no line meets anything else than windings of 0 and 1
/// along more than the rounding: then the sum over all triangles is right. Throws Cancelled.
Region find_region(const Soup& soup, const std::vector<std::uint32_t>& part,
                   const Progress& progress = {});

/// The mass of the region that closed triangles bound, whose parts are given.
MassProperties mass_of(const Region& region, const Progress& progress = {});

}  // namespace sonde
