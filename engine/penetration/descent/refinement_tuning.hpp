// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace sonde {

/// Constants of a refinement (Refinement), which takes an end of a search to full accuracy. Unless
/// a line says otherwise, they were chosen by trial on the poses of `tests/reference/depths.csv`
/// (`sonde-depths`).
struct RefinementTuning {
  /// One stage of leaps (LeapGoal).
  struct Leaps {
    double tolerance;  ///< share of |y|
    int steps;         ///< maximum number
    double reach;      ///< share of |y|: maximum length of the first leap
  };
  Leaps first{1e-3, 20, 0.05};    ///< guided by few pairs
  Leaps second{1e-4, 30, 0.005};  ///< guided by many pairs
  /// Share of the time; the rest is for moving into contact.
  double share_for_leaps = 0.95;
  /// Pairs that the rows of the swept descent are made of. A neighbour list would pay only for many
  /// short steps; here there are few.
  std::size_t most_pairs = 512;
  /// Steps of the swept descent. A pose that has not converged by then (flat parts of hundreds of
  /// triangles, where a step costs 1 ms) is no nearer by a thousandth after 60. The result says
  /// that it has not converged.
  int most_swept = 20;
  double expected_step = 1e-3;  ///< share of |y|: expected distance of the end
  /// Units of Effort, about 0.1 ms: cost of a gather and a sweep into contact, for a pose whose
  /// contacts are still unknown when the time has run out.
  std::int64_t last_look = 10'000;
  /// µs: time limit of the overlap tests that pull such a pose in before, and, as a share of |y|,
  /// the expected distance of its contacts after that. With these values, contacts are named on 239
  /// to 241 of 244 poses in 1 ms, with a p99 of 1.30 to 1.41; with 0.008 on 236 to 241, with the
  /// gather alone on 236 to 239 (1.26 to 1.31), and with a gather of three times the effort on 241
  /// (1.43 to 1.55).
  double us_of_last_pull = 100;
  double expected_after_pull = 0.004;
};
inline constexpr RefinementTuning refinement_tuning;

}  // namespace sonde
