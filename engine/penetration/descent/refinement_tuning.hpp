// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace sonde {

/// The numbers of a refinement (Refinement): how an end of a search is taken to the last digit.
/// Chosen by trial on the poses of `tests/reference/depths.csv` (`sonde-depths`), but where a line
/// says otherwise.
struct RefinementTuning {
  /// One stage of leaps (LeapGoal).
  struct Leaps {
    double tolerance;  ///< of |y|
    int steps;         ///< at most
    double reach;      ///< of |y|: the first leap at most
  };
  Leaps first{1e-3, 20, 0.05};    ///< by few pairs
  Leaps second{1e-4, 30, 0.005};  ///< by many
  /// Of the time: the rest is for coming into contact.
  double share_for_leaps = 0.95;
  /// Pairs that the rows of the sweep are made of; a list of pairs pays for many short steps, of
  /// which there are few here.
  std::size_t most_pairs = 512;
  /// Steps of the sweep: what has not converged by then (flat parts of hundreds of triangles, where
  /// a step costs 1 ms) is no nearer by a thousandth after 60. The result says that it has not.
  int most_swept = 20;
  double expected_step = 1e-3;  ///< of |y|: how far the end is thought to be
  /// Units of Effort, 0.1 ms or so: what a look and a sweep into contact take, of what is out of
  /// time before anything is known of its contacts.
  std::int64_t last_look = 10'000;
  /// µs: until when it is first pulled in, by tests of overlap; and of |y|, how far its contacts
  /// are thought to be then. With these, contacts are named on 239 to 241 of 244 poses in 1 ms,
  /// with a p99 of 1.30 to 1.41; with 0.008 on 236 to 241, with the look alone on 236 to 239 (1.26
  /// to 1.31), and with a look of three times as much on 241 (1.43 to 1.55).
  double us_of_last_pull = 100;
  double expected_after_pull = 0.004;
};
inline constexpr RefinementTuning refinement_tuning;

}  // namespace sonde
