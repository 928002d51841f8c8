// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// Constants of pushing overlaps apart (PushApart). They decide how often it succeeds, not whether
/// its result is free. Chosen by trial on the device poses of `tests/reference/depths.csv`: with
/// these, 178 of the 244 become free, and 126 of them lead down to the reference depth, to 1 %.
/// Lengths are in parts of R, the probe's radius.
struct PushApartTuning {
  /// Maximum number of steps. After that, this start is given up and another one is tried.
  int most_looks = 25;
  /// Pairs that one step considers. The pairs of a deep overlap contradict each other; more of them
  /// cost more and do not succeed more often.
  std::size_t most_pairs = 48;
  double margin = 2e-4;  ///< distance to which triangles are separated
  /// |v| of the pose: beyond it the chart, which ends at 1, is too far from linear, and the start
  /// is given up.
  double largest_start_v = 0.9;
  /// Cosine between the outward normal of a solid's face and a separating direction: a direction
  /// that points inwards by no more than this is still allowed, because a direction in the plane of
  /// a face leads neither in nor out.
  double aside = 0.1;
  double parallel = 1e-12;  ///< squared sine: edges more nearly parallel give no direction

  // The compromise between pairs
  int sweeps = 8;     ///< Gauss-Seidel sweeps; the next step handles what is not settled
  double give = 0.3;  ///< share of a row's |n|²: how far it yields to contradicting rows
};
inline constexpr PushApartTuning push_apart_tuning;

}  // namespace sonde
