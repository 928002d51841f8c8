// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/base/deadline.hpp"
#include "engine/body/body.hpp"

namespace sonde {

struct BoundOptions {
  /// Counted work, the same bits for the same work: a cell of rotations is 1, a point's depth in
  /// both bodies is 10. It ends before that where half as much again raised the bound by less
  /// than 2 %. The more, the nearer to what can be shown by one point at a time
  /// (resources/docs/understand/penetration.md has the trade).
  int work = 20'000;
};

/// A certified lower bound of the depth √PD_g of probe A at X_FM against B, metres, rounded down;
/// no value where both bodies are surfaces. A point that lies a deep in A and b deep in B (negative
/// outside) must be displaced by a + b, whatever the motion. Rotations are covered by cells, and in
/// each the point that helps most says how far the centre of mass must go besides. 0 where no point
/// is found in both (or not before the deadline).
std::optional<double> depth_lower_bound(const Body& probe, const Body& fixed, const Pose& X_FM,
                                        const Deadline& deadline = {},
                                        const BoundOptions& options = {});

/// What shows most of a bound by itself: a point that lies deep in the two bodies together, at the
/// pose asked about; it may lie outside the one, so much deeper in the other. The probe's point
/// there must be moved by `depth`, whatever the motion that separates them.
struct BoundWitness {
  Vec3 at = Vec3::Zero();  ///< in the fixed body's mesh frame, m
  double depth = 0;        ///< how deep it lies in the two bodies together, m
};
struct LowerBound {
  double depth = 0;                          ///< as of depth_lower_bound, m
  std::optional<BoundWitness> witness = {};  ///< none where no such point was found
};
/// The same bound with its witness.
std::optional<LowerBound> witnessed_lower_bound(const Body& probe, const Body& fixed,
                                                const Pose& X_FM, const Deadline& deadline = {},
                                                const BoundOptions& options = {});

}  // namespace sonde
