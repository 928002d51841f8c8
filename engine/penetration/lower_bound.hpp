// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/geometry/body.hpp"
#include "engine/penetration/deadline.hpp"

namespace sonde {

/// A certified lower bound of the depth √PD_g of probe A at X_FM against B, metres, rounded down;
/// no value where both bodies are surfaces. For a point x of A inside solid B at distance d from
/// B's triangles and r = x − com: σ ≥ d² / (1 + μ), μ = max over unit n of |n×r|² / (nᵀÎn); the
/// same for a point of B inside solid A. Corners are tried, and where both are solids points inside
/// both. 0 where no such point is found (or not before the deadline).
std::optional<double> depth_lower_bound(const Body& probe, const Body& fixed, const Pose& X_FM,
                                        const Deadline& deadline = {});

}  // namespace sonde
