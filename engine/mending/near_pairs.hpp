// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/base/error.hpp"

namespace sonde {

/// Calls use(i, j), i < j, for each two of some boxes that meet, found by a tree over them. Returns
/// false where more than `most` pairs would have to be compared; then some were not used. Throws
/// Cancelled.
bool each_near_pair(const std::vector<Eigen::AlignedBox3d>& boxes, std::size_t most,
                    const std::function<void(std::uint32_t, std::uint32_t)>& use,
                    const Progress& progress = {});

}  // namespace sonde
