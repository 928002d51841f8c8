// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/contact/contact_rows.hpp"
#include "engine/penetration/descent/descent.hpp"

namespace sonde {

/// The contacts that guide a leap: those of the bodies' outlines (roughly()), or those of the
/// bodies themselves, made from the nearest few pairs or from many pairs.
enum class Guide { outlines, few, many };

/// When a descent by leaps has converged, and when it gives up.
struct LeapGoal {
  Guide guide = Guide::outlines;
  double tolerance = 0.02;  ///< share of |y|: shorter steps end the descent
  int steps = 15;           ///< maximum number of iterations
  double reach = 0.3;       ///< share of |y|: maximum length of the first leap
  /// m: the descent stops if the near contacts show that it will not end below this. 0: never.
  double beat = 0;
};

/// Local optimisation for a search, where only the end pose counts. A leap goes from a free pose
/// directly to the point nearest to the origin that the near contacts allow. If that pose is not
/// free, the leap goes only a part of the distance. The poses in between are not examined, which
/// makes a leap fast. Each pose at which a leap ends is free (by overlap with doubt as contact),
/// whatever the outlines are like.
class LeapDescent {
 public:
  LeapDescent(const Body& probe, const Body& fixed, Method method);

  /// From now on, adds the time spent in each phase to `times`. Null: records no times.
  void time_into(PhaseTimes* times) noexcept;
  /// Restricts all poses to a subspace (ContactRows::stay_within). Runs must begin in it.
  void stay_within(const Mat6& onto);
  /// Runs from the free pose at y in the chart of the device pose. The contacts and the residual
  /// are meaningful only if the bodies' own contacts guided it.
  Descent::Outcome run(const Chart& chart, const Vec6& y, const LeapGoal& goal,
                       const Deadline& deadline);

  bool is_free(const Chart& chart, const Vec6& y) const;
  /// Bisects from the free pose at y straight towards the origin. Returns a nearer free pose, or y.
  Vec6 pull_in(const Chart& chart, const Vec6& y, const Deadline& deadline = {}) const;

  /// Number of leaps so far that were cut short because there was no room for more rows, or because
  /// the maximum number of checks was reached. This does not affect whether an end pose counts as
  /// converged: that depends only on the rows that hold it.
  int limited() const { return limited_; }

 private:
  struct Pace;
  ContactRows& rows(Guide guide);
  /// Moves y towards the solution of the rows: to it, or to a free pose on a part of the distance.
  /// Returns false if it found no free pose, or if the time ran out.
  bool leap(const Chart& chart, const LeastDistance& nearest, double margin, ContactRows& rows,
            Pace& pace, Vec6& y, const Deadline& deadline);
  /// A leap to a free pose that avoids the obstacles of the leap `first`, with rows for all of
  /// these obstacles (ContactRows::add_cuts).
  std::optional<Vec6> detour(const Chart& chart, const Vec6& first, double margin,
                             ContactRows& rows, double trust, const Vec6& y,
                             const Deadline& deadline);

  const Body& probe_;
  const Body& fixed_;
  Method method_;
  std::optional<Mat6> onto_;
  PhaseTimes* times_ = nullptr;
  int limited_ = 0;
  std::array<std::optional<ContactRows>, 3> rows_;  // each constructed on first use
};

}  // namespace sonde
