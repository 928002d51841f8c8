// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/deadline.hpp"
#include "engine/penetration/bound/witness.hpp"

namespace sonde {

/// A few points, apart from each other, that lie deep in both bodies at the device pose. They come
/// from intersecting triangles, from corners, and, if both bodies are solids, from a cover of their
/// overlap. `work` is that of the bound (BoundOptions): the corners of each body take a twentieth
/// of it, the rest some 50 evaluations. Empty if no point has a positive depth. Allocates.
std::vector<CommonPoint> deep_points(const CommonDepth& depth, int work, const Deadline& deadline);

}  // namespace sonde
