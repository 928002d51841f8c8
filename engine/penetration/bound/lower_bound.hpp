// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "engine/base/deadline.hpp"
#include "engine/body/body.hpp"

namespace sonde {

struct BoundOptions {
  /// Limit of the counted work; the same work gives the same bits. A cell of rotations costs 1, a
  /// point's depth in both bodies 10. The search ends earlier if an increase of the work by half
  /// raised the bound by less than 2 %. More work brings the bound nearer to the best that single
  /// points can prove ("How sharp the lower bound is" in resources/docs/understand/penetration.md).
  int work = 20'000;
  /// Whether the bound is of √PD_t, which is no lower, rather than √PD_g.
  bool translations = false;
  /// m: the depth of a known separation. If the bound reaches half of it, no crossings are searched
  /// for. Infinite: unknown.
  double known = std::numeric_limits<double>::infinity();
};

/// A certified lower bound of the depth √PD_g (PD_g is in m², the depth and this bound in m) of
/// probe A at X_FM against B, rounded down. A point at depth a in A and depth b in B (negative
/// outside) must be displaced by a + b, whatever the motion. Cells cover the rotations; in each
/// cell, the point that gives the largest bound determines how far the centre of mass must move in
/// addition to the turn. Where points prove little, as in thin bodies and surfaces, curves on one
/// surface that pierce the other one (Crossing) may prove more. No value if both bodies are
/// surfaces and no such curve was found; 0 if otherwise nothing was found (or nothing before the
/// deadline). The proofs are in "Lower bound" of resources/docs/understand/mathematics.md.
std::optional<double> depth_lower_bound(const Body& probe, const Body& fixed, const Pose& X_FM,
                                        const Deadline& deadline = {},
                                        const BoundOptions& options = {});

/// The point that proves most of a bound on its own, at the given pose. Its depths in the two
/// bodies are added; it may lie outside one body if it is deeper in the other by more. Any motion
/// that separates the bodies displaces this point of the probe by at least `depth`.
struct BoundWitness {
  Vec3 at = Vec3::Zero();  ///< in the fixed body's mesh frame, m
  double depth = 0;        ///< sum of its depths in the two bodies, m
};
struct LowerBound {
  double depth = 0;                          ///< as from depth_lower_bound, m
  std::optional<BoundWitness> witness = {};  ///< none where no such point was found
};
/// The same bound, with the point that proves most of it.
std::optional<LowerBound> witnessed_lower_bound(const Body& probe, const Body& fixed,
                                                const Pose& X_FM, const Deadline& deadline = {},
                                                const BoundOptions& options = {});

}  // namespace sonde
