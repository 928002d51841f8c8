// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/base/effort.hpp"
#include "engine/body/body.hpp"

namespace sonde {

/// A pair of triangles that is too near, or meets, at a pose that is thought of.
struct Violation {
  std::uint32_t triangle_a, triangle_b;
  double gap;  ///< m; at most 0 where they meet
};

/// Pairs nearer than `least` (m) at X, or meeting, as they are found: as many as `out` holds, in
/// which case there may be more. Returns how many. Never allocates.
std::size_t find_violations(const Body& a, const Body& b, const Transform& X_BA, double least,
                            std::span<Violation> out, Effort& effort);

}  // namespace sonde
