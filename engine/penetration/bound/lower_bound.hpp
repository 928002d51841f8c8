// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/base/deadline.hpp"
#include "engine/body/body.hpp"

namespace sonde {

struct BoundOptions {
  /// Counted work; the same work gives the same bits. A cell of rotations counts 1, a point's depth
  /// in both bodies 10. The search ends earlier where half as much again raised the bound by less
  /// than 2 %. More work brings the bound nearer to what one point at a time can prove
  /// ("How sharp the lower bound is" in resources/docs/understand/penetration.md).
  int work = 20'000;
};

/// A certified lower bound of the depth √PD_g (PD_g is in m², the depth and this bound in m) of
/// probe A at X_FM against B, rounded down. No value where both bodies are surfaces. A point that
/// lies a deep in A and b deep in B (negative outside) must be displaced by a + b, whatever the
/// motion. Cells cover the rotations. In each cell, the most useful point says how far the centre
/// of mass must go besides. 0 where no point lies in both bodies (or none was found before the
/// deadline). The proof is in "Lower bound" of resources/docs/understand/mathematics.md.
std::optional<double> depth_lower_bound(const Body& probe, const Body& fixed, const Pose& X_FM,
                                        const Deadline& deadline = {},
                                        const BoundOptions& options = {});

/// The point that proves most of a bound by itself, at the given pose. Its depths in the two bodies
/// are added; it may lie outside one and so much deeper in the other. Whatever motion separates the
/// bodies, it must displace the probe's point there by `depth`.
struct BoundWitness {
  Vec3 at = Vec3::Zero();  ///< in the fixed body's mesh frame, m
  double depth = 0;        ///< sum of its depths in the two bodies, m
};
struct LowerBound {
  double depth = 0;                          ///< as from depth_lower_bound, m
  std::optional<BoundWitness> witness = {};  ///< none where no such point was found
};
/// The same bound with its witness.
std::optional<LowerBound> witnessed_lower_bound(const Body& probe, const Body& fixed,
                                                const Pose& X_FM, const Deadline& deadline = {},
                                                const BoundOptions& options = {});

}  // namespace sonde
