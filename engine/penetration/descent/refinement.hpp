// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/body/body.hpp"
#include "engine/penetration/descent/leap_descent.hpp"

namespace sonde {

/// Refines an end pose of a search to full accuracy by the contacts of the bodies: with leaps, and
/// with a swept descent if these do not converge.
class Refinement {
 public:
  Refinement(const Body& probe, const Body& fixed, Method method);

  /// From now on, adds the time spent in each phase to `times`. Null: records no times. The leaps
  /// have their own time_into.
  void time_into(PhaseTimes* times) noexcept { descent_.time_into(times); }
  /// Restricts all poses to a subspace (ContactRows::stay_within). The leaps have their own
  /// stay_within.
  void stay_within(const Mat6& onto) { descent_.stay_within(onto); }
  /// Starts from the free pose at y. If the steps or the time run out, returns the nearest pose
  /// reached, moved into contact as far as the time allows. If the time has run out and no contact
  /// of that pose is known yet, overlap tests move it nearer, for at most 0.1 ms, and a search for
  /// its contacts takes about another 0.1 ms.
  Descent::Outcome run(const Chart& chart, const Vec6& y, LeapDescent& leaps, int steps,
                       const Deadline& deadline);

 private:
  Descent descent_;
};

}  // namespace sonde
