// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/restricted/one_way.hpp"

namespace sonde {

/// The first pose of a way at which the probe is free.
struct FirstFree {
  double s = 0;  ///< along the way, m or rad
  Pose X_FM;     ///< there; free by the exact test
  /// The triangles of surface(probe) and surface(fixed) that meet just before.
  std::uint32_t triangle_a = 0, triangle_b = 0;
};

/// The least s up to `most` (m or rad, positive) at which the probe is free. Nothing is stepped
/// over, but gaps narrower than rounding: between the places at which two triangles may begin or
/// cease to meet, nothing changes, and these places are the roots of their coordinates on the way
/// (OneWay::events). The pose is some roundings of the coordinates beyond the place. No value where
/// no pose up to `most` is free. Allocates.
/// @throws Cancelled where `progress`, which is told the part of the way that was looked at, says
/// so.
std::optional<FirstFree> nearest_free(const Body& probe, const Body& fixed, const OneWay& way,
                                      double most, const Progress& progress = {});

}  // namespace sonde
