// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace sonde::bench {

/// What a library said to one query at one pose, as far as it can be compared.
struct Answer {
  std::optional<bool> touch;
  std::optional<double> distance;    ///< m
  std::optional<double> free_until;  ///< of a sweep: the share of the path before the contact
  std::optional<double> amount;      ///< rows, or bytes per triangle: shown, not compared
  std::shared_ptr<void> built;       ///< freed after the clock has been read
};

/// Distances that differ by more than this are different answers, m (the bodies' radius is 1 m).
constexpr double distance_tolerance = 1e-6;

enum class Verdict {
  agree,
  excused,  ///< differs where the other library's numbers cannot tell
  missed,   ///< the other library is known to be wrong, which is counted and shown
  wrong     ///< the benchmark fails
};

/// `from_touching`: how far the pose is from the pose just touching, m. `doubtful_within`: how near
/// to it the other library's numbers cannot tell, m; 0 where it has no excuse.
Verdict judge_touch(bool ours, bool theirs, double from_touching, double doubtful_within);
/// Not a number is wrong.
Verdict judge_distance(double ours, double theirs);
/// The worse of the two for what both answered; agree where they answered nothing in common.
Verdict judge(const Answer& ours, const Answer& theirs, double from_touching,
              double doubtful_within);

/// "touches, distance 0.001 m".
std::string to_text(const Answer& answer);

}  // namespace sonde::bench
