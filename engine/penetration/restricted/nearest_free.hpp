// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/restricted/one_dof_motion.hpp"

namespace sonde {

/// The first free pose on a one-parameter motion.
struct FirstFree {
  double s = 0;  ///< parameter of the motion, m or rad
  Pose X_FM;     ///< the pose at s; free by the exact test
  /// The triangles of surface(probe) and surface(fixed) that intersect just before.
  std::uint32_t triangle_a = 0, triangle_b = 0;
};

/// The least s up to `most` (m or rad, positive) at which the probe is free. Skips no free interval
/// except those narrower than rounding: two triangles can begin or cease to intersect only at the
/// values of s that OneDofMotion::events finds (roots of functions of s), and nothing changes
/// between these. The pose lies a few rounding errors beyond the root. No value if no pose up to
/// `most` is free. Allocates.
/// @throws Cancelled if `progress`, which is called with the share of the range examined so far,
/// returns false.
std::optional<FirstFree> nearest_free(const Body& probe, const Body& fixed,
                                      const OneDofMotion& motion, double most,
                                      const Progress& progress = {});

}  // namespace sonde
