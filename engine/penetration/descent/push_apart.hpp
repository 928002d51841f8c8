// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "engine/base/deadline.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/penetration/contact/least_distance.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/queries/violation.hpp"

namespace sonde {

/// Finds a free pose near an overlapping one from the triangles that intersect: it separates each
/// pair along the direction that needs the least displacement and leads out of a solid on the side
/// on which the triangle entered it. This heuristic fails for deep overlaps. But it reaches free
/// poses in gaps and holes that are too narrow for random poses to hit and for sketches to resolve.
class PushApart {
 public:
  PushApart(const Body& probe, const Body& fixed, Method method);

  /// From now on, adds the time spent in each phase to `times`. Null: records no times.
  void time_into(PhaseTimes* times) noexcept { times_ = times; }
  /// A free pose (by overlap with doubt as contact) near y, in the chart of the device pose, with
  /// |y| < `farthest` (m) if the given y is within that ball. The first pushes mostly lead out of
  /// the ball; then the probe is moved straight back into it, and the remaining pairs push it
  /// sideways, along the body.
  std::optional<Vec6> from(const Chart& chart, const Vec6& y, double farthest,
                           const Deadline& deadline = {});

 private:
  struct Row {
    HalfSpace half_space;  ///< constraint on the step
    double push;           ///< its multiplier
  };
  bool is_free(const Chart& chart, const Vec6& y) const;
  /// Makes rows of the pairs that intersect, or nearly do, at the origin of the chart `here`; the
  /// step begins there. (In the device's chart, a turn near half a turn has steps of no length, and
  /// a push across it would leave the chart.)
  void gather(const Chart& here, double margin);
  /// Limits the displacement that a row demands to a multiple of the median.
  void limit_displacements();
  /// A step that satisfies the rows about evenly.
  Vec6 compromise();
  Vec6 moved(const Chart& chart, const Vec6& y, const Chart& here, const Vec6& step) const;

  const Body& probe_;
  const Body& fixed_;
  Method method_;
  PhaseTimes* times_ = nullptr;
  std::vector<Violation> found_;
  std::vector<Row> rows_;
  std::vector<double> displacements_;  // m: the displacement that each row demands
};

}  // namespace sonde
