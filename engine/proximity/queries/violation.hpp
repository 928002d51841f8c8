// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/base/effort.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"

namespace sonde {

/// A pair of triangles that is too near, or that meets, at a trial pose.
struct Violation {
  std::uint32_t triangle_a, triangle_b;
  double gap;  ///< m; at most 0 if they meet
};

/// Writes pairs that are nearer than `least` (m) at X, or meet, in the order in which it finds
/// them. If `out` is full, there may be more. Returns their number. Never allocates.
std::size_t find_violations(const Body& a, const Body& b, const Transform& X_BA, double least,
                            std::span<Violation> out, Effort& effort);

}  // namespace sonde
