// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {

/// Criteria for a part of a soup to be a solid. Lines in general position look at it from all
/// around; the *mouth* of a part is the largest share of their ends on it that falls on one cap not
/// covered by another part.
struct PartTuning {
  /// A part with a wider mouth is a vessel or a sheet, which counts as a solid only if the user
  /// says so. Real solids with holes have at most 0.011, vessels at least 0.050, sheets at least
  /// 0.38 (the histogram is in resources/docs/use/files.md).
  double widest_mouth = 0.025;
  /// Share of the ends that may fall on all caps of a part together.
  double most_open = 0.38;
  /// Times area and size: volume that is indistinguishable from the rounding of a closed flat mesh.
  double flat = 1e-12;
  /// The same for a volume counted by lines, which detect lobes that cancel in the sum.
  double flat_by_lines = 1e-9;
  /// Times the part's size: thinner lobes are rounding, on a sheet and its lid.
  double thinnest_lobe = 1e-6;
  int lines = 256;      ///< along a side of the raster, in each of three directions
  int own_lines = 128;  ///< for a part by itself
  int flat_lines = 64;  ///< to look for lobes
  /// Line ends that a part needs to be judged together with all others. With fewer, it gets lines
  /// of its own: through all parts for `most_rasters` such parts, and through itself alone beyond.
  std::size_t fewest_ends = 1000;
  std::size_t most_rasters = 32;
  int few_lines = 24;  ///< along a side of these last rasters, which may be very many
};
inline constexpr PartTuning part_tuning;

/// The facts known of a part.
struct PartFacts {
  std::size_t triangles = 0;  ///< without caps
  std::size_t caps = 0;
  std::size_t torn = 0;    ///< edges at which triangles cannot agree: it is not two-sided
  double area = 0;         ///< m², without caps
  double volume = 0;       ///< m³, signed, with caps
  bool flat = false;       ///< even with its caps, it bounds no inside
  bool both_ways = false;  ///< all of it is there in both orientations (set by the mender)
  double mouth = 0;        ///< largest share of line ends that falls on one cap
  std::uint32_t mouth_cap = Sealed::no_cap;  ///< that cap
  double open = 0;                           ///< share of line ends that falls on caps
  /// Closed to the eye: it bounds an inside unless the user says otherwise.
  bool looks_solid() const {
    return !flat && torn == 0 && mouth <= part_tuning.widest_mouth && open <= part_tuning.most_open;
  }
};

/// The facts of all parts. Throws Cancelled.
std::vector<PartFacts> judge_parts(const Sealed& sealed, const std::vector<Cap>& caps,
                                   const std::vector<std::size_t>& torn,
                                   const Progress& progress = {});

}  // namespace sonde
