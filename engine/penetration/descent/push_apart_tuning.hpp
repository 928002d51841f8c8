// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace sonde {

/// The numbers by which overlaps are pushed apart (PushApart). They decide how often it comes out,
/// not whether what it comes to is free. Chosen by trial on the device poses of
/// `tests/reference/depths.csv`: with these 178 of the 244 come free, and 126 of them lead down to
/// the reference depth, to 1 %. Lengths are in parts of R, the probe's radius.
struct PushApartTuning {
  /// Looks at where the probe has come to, before this start is given up: another one is tried.
  int most_looks = 25;
  /// Pairs that one look takes down. Those of a deep overlap contradict each other; more of them
  /// are more work, and lead out no oftener.
  std::size_t most_pairs = 48;
  double margin = 2e-4;  ///< how far apart triangles are to be
  /// |v| of the pose: beyond it the chart, which ends at 1, is too far from linear. The start is
  /// given up.
  double largest_start_v = 0.9;
  /// Cosine between a face and a way out of it: a direction in the plane of a face leads neither in
  /// nor out.
  double aside = 0.1;
  double parallel = 1e-12;  ///< sine, squared: edges that give no direction of their own

  // The compromise between pairs
  int sweeps = 8;     ///< of Gauss and Seidel: what is not settled by then the next look is for
  double give = 0.3;  ///< of a row's size: by how much it yields to others that contradict it
};
inline constexpr PushApartTuning push_apart_tuning;

}  // namespace sonde
