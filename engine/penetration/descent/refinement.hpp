// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"
#include "engine/penetration/descent/leap_descent.hpp"

namespace sonde {

/// From an end of a search to the last digit, by the contacts of the bodies: leaps, and what they
/// do not bring to an end is swept there.
class Refinement {
 public:
  Refinement(const Body& probe, const Body& fixed, Method method);

  /// Adds the times of phases to `times` from now on; null: to nothing. The leaps have their own.
  void time_into(PhaseTimes* times) noexcept { descent_.time_into(times); }
  /// Keeps all of its poses in a subspace (ContactRows::stay_within). The leaps have their own.
  void stay_within(const Mat6& onto) { descent_.stay_within(onto); }
  /// From the free pose at y. Where the steps or the time run out, the nearest pose reached, let
  /// come into contact as far as there is time; or, where nothing is known of its contacts by then,
  /// pulled in by tests of overlap that begin within 0.1 ms, and as far as 0.1 ms more go.
  Descent::Outcome run(const Chart& chart, const Vec6& y, LeapDescent& leaps, int steps,
                       const Deadline& deadline);

 private:
  Descent descent_;
};

}  // namespace sonde
