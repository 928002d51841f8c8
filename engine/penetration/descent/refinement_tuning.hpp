// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
  /// Maximum number of steps of the swept descent. A pose that has not converged by then (on flat
  /// parts of hundreds of triangles, where a step costs 1 ms) is not even a thousandth nearer after
  /// 60 steps. The result then says that it has not converged.
  int most_swept = 20;
  double expected_step = 1e-3;  ///< share of |y|: expected distance of the end
  /// Units of Effort, about 0.1 ms: limit of a gather and a sweep into contact, for a pose whose
  /// contacts are still unknown when the time has run out.
  std::int64_t last_look = 10'000;
  /// For the overlap tests that move such a pose nearer before the gather: their time limit (µs),
  /// and, as a share of |y|, the expected distance of the contacts after them. With these values
  /// and a budget of 1 ms, contacts are reported on 239 to 241 of 244 poses, with a p99 of 1.30 to
  /// 1.41 ms. With 0.008 it is 236 to 241 poses; with the gather alone 236 to 239 (p99 1.26 to 1.31
  /// ms); with a gather of three times the effort 241 (p99 1.43 to 1.55 ms).
  double us_of_last_pull = 100;
  double expected_after_pull = 0.004;
};
inline constexpr RefinementTuning refinement_tuning;

}  // namespace sonde
