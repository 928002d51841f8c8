// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/compare.hpp"

#include <algorithm>
#include <cmath>

#include "engine/text/number_text.hpp"

namespace sonde::bench {

Verdict judge_touch(bool ours, bool theirs, double from_touching, double doubtful_within) {
  if (ours == theirs) return Verdict::agree;
  return from_touching < doubtful_within ? Verdict::excused : Verdict::wrong;
}

Verdict judge_distance(double ours, double theirs) {
  return std::abs(ours - theirs) <= distance_tolerance ? Verdict::agree : Verdict::wrong;
}

Verdict judge(const Answer& ours, const Answer& theirs, double from_touching,
              double doubtful_within) {
  Verdict out = Verdict::agree;
  if (ours.touch && theirs.touch)
    out = std::max(out, judge_touch(*ours.touch, *theirs.touch, from_touching, doubtful_within));
  if (ours.distance && theirs.distance)
    out = std::max(out, judge_distance(*ours.distance, *theirs.distance));
  return out;
}

std::string to_text(const Answer& answer) {
  std::string text;
  if (answer.touch) text += *answer.touch ? "touches" : "does not touch";
  if (answer.distance)
    text += (text.empty() ? "distance " : ", distance ") + number_text(*answer.distance, 17) + " m";
  if (answer.free_until) text += ", free until " + number_text(*answer.free_until, 17);
  return text.empty() ? "no answer" : text;
}

}  // namespace sonde::bench
