// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reference/measure.hpp"

namespace sonde::reference {

/// What a local method for PD_t finds from nothing, as PolyDepth goes about it (Je and others, ACM
/// Transactions on Graphics 31(1), 2012): from a free pose out along the line of the centres of
/// mass straight at the device pose until they touch, then in turn to the nearest point that the
/// planes of the contacts allow and back to contact on the way there, until it stays. The sweeps
/// and the contacts are Sonde's own (CoherentSolver), so this is the method, not that program. The
/// time is processor time; the pose out there is not counted, and there is no bound.
Measured measure_one_projection(const Row& row, const Pair& pair);

}  // namespace sonde::reference
