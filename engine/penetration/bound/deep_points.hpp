// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/deadline.hpp"
#include "engine/penetration/bound/witness.hpp"

namespace sonde {

/// A few points, apart from each other, that lie deep in both bodies at the device pose: from where
/// triangles meet, from corners, and between two solids from a cover of where they overlap. Some
/// 250 evaluations. Empty where none of positive depth was found. Allocates.
std::vector<CommonPoint> deep_points(const CommonDepth& depth, const Deadline& deadline);

}  // namespace sonde
