// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// The poses X_FM among the given ones at which the probe overlaps the fixed body: at most `most`
/// of them, evenly chosen in their order; 0: all of them. Throws Cancelled.
std::vector<Pose> overlapping_poses(const Body& probe, const Body& fixed,
                                    std::span<const Pose> poses, std::size_t most,
                                    const Stop& stop);

/// Random poses X_FM at which the probe overlaps the fixed body. A random point of the probe's
/// surface lies on a random point of the fixed body's, both uniform by area; the rotation is
/// uniform over all rotations. Poses that do not overlap (corners that just touch) are drawn again.
/// The depths range from grazing to deep. Returns fewer poses than requested only if almost none
/// overlaps. Throws Cancelled.
std::vector<Pose> random_overlapping_poses(const Body& probe, const Body& fixed, std::size_t count,
                                           std::uint64_t seed, const Stop& stop);

}  // namespace sonde
