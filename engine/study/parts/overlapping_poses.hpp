// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/study/parts/study_parts.hpp"

namespace sonde {

/// At most `most` of the poses X_FM at which the probe overlaps the fixed body, evenly chosen from
/// all of those in their order; 0: all of them. Throws Cancelled.
std::vector<Pose> overlapping_poses(const Body& probe, const Body& fixed,
                                    std::span<const Pose> poses, std::size_t most,
                                    const Stop& stop);

/// Random poses X_FM at which the probe overlaps the fixed body: a random point of the probe's
/// surface lies on a random point of the fixed body's, both uniform by area, the probe at any turn,
/// uniform over all rotations; those that do not overlap (corners that just touch) are drawn again.
/// From grazing to deep, as the surfaces lie. Fewer than asked only where nearly none overlaps.
/// Throws Cancelled.
std::vector<Pose> random_overlapping_poses(const Body& probe, const Body& fixed, std::size_t count,
                                           std::uint64_t seed, const Stop& stop);

}  // namespace sonde
