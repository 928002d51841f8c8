// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"

namespace sonde {

/// What a pair of triangles in doubt counts as: decided by exact predicates (may allocate), or
/// taken as contact (never allocates; errs on the side of contact).
enum class Doubt { exact, contact };

/// Does any triangle of A, placed at X_BA, meet or touch one of B? First hit.
bool triangles_meet(const Body& a, const Body& b, const Transform& X_BA, Doubt doubt);

/// triangles_meet, or a connected component of either lies inside the other where that is a solid.
/// The negation is *free*.
bool overlap(const Body& a, const Body& b, const Transform& X_BA, Doubt doubt);

}  // namespace sonde
