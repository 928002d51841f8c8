// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/geometry/pose.hpp"

namespace sonde {

/// The seed of a search at a pose, made from `seed` and the bits of the pose by the steps of
/// splitmix64 (Steele, Lea, Flood 2014). One run over many poses thus gives each its own random
/// starts, and the answer depends neither on its row nor on its file, thread or shard. q and −q are
/// one turn and have one seed, as have 0 and −0. (The readers of poses scale q to length 1 first.)
std::uint64_t seed_of_pose(std::uint64_t seed, const Pose& X_FM);

}  // namespace sonde
