// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/body.hpp"
#include "engine/penetration/contact_rows.hpp"
#include "engine/penetration/descent.hpp"

namespace sonde {

/// When a descent by leaps is good enough, or not worth going on with.
struct LeapGoal {
  double tolerance = 0.02;  ///< of |y|: steps shorter than this share of it end the descent
  int steps = 15;           ///< iterations at most
  double reach = 0.3;       ///< of |y|: the length of the first leap at most
  /// m: stopped where the contacts near by say that it will not end below. 0: never.
  double beat = 0;
  bool roughly = true;  ///< contacts of the outlines guide it, where bodies have them
};

/// Local optimisation for a search, where only the end counts: from a free pose towards the point
/// nearest to the origin that the contacts near by allow, and there, if that is free, at once; else
/// a part of the way. What lies between is not looked at, which is what makes it quick. Each pose
/// on the way is free (by overlap with doubt as contact), whatever the outlines are like.
class LeapDescent {
 public:
  LeapDescent(const Body& probe, const Body& fixed, Method method);

  struct Outcome {
    Vec6 y = Vec6::Zero();
    int iterations = 0;
    double last_step = 0;    ///< m
    bool converged = false;  ///< to the tolerance
  };
  /// From the free pose at y in the chart of the device pose.
  Outcome run(const Chart& chart, const Vec6& y, const LeapGoal& goal, const Deadline& deadline);

  bool is_free(const Chart& chart, const Vec6& y) const;
  /// From the free pose at y straight towards the origin, by bisection: a free pose with no less
  /// room for being nearer, which need not be the first one on the way.
  Vec6 pull_in(const Chart& chart, const Vec6& y) const;

 private:
  ContactRows& rows(bool roughly) { return roughly ? rough_ : exact_; }
  const Body& probe_;
  const Body& fixed_;
  ContactRows rough_, exact_;
};

}  // namespace sonde
