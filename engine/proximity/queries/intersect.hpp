// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// How to treat an undecided pair of triangles: decide by exact predicates (may allocate), or count
/// it as contact (never allocates; errs on the side of contact).
enum class Doubt { exact, contact };

/// Returns whether any triangle of A, placed at X_BA, meets or touches one of B. Stops at the first
/// such pair.
bool triangles_meet(const Body& a, const Body& b, const Transform& X_BA, Doubt doubt);

/// triangles_meet, or a connected component of one body lies inside the other, if that is a solid.
/// A pose without overlap is called *free*.
bool overlap(const Body& a, const Body& b, const Transform& X_BA, Doubt doubt);

}  // namespace sonde
