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

/// Finds a free pose near an overlapping one from the triangles that intersect: each pair is to be
/// separated along the direction that needs the least displacement, out of the side of a solid at
/// which it entered. This is a heuristic that fails for deep overlaps; but it finds its way into
/// gaps and holes that are too narrow for random poses to hit and for sketches to resolve.
class PushApart {
 public:
  PushApart(const Body& probe, const Body& fixed, Method method);

  /// Adds the times of phases to `times` from now on; null: to nothing.
  void time_into(PhaseTimes* times) noexcept { times_ = times; }
  /// A free pose (by overlap with doubt as contact) near y, in the chart of the device pose. Gives
  /// up if |y| reaches `farthest`, m.
  std::optional<Vec6> from(const Chart& chart, const Vec6& y, double farthest,
                           const Deadline& deadline = {});

 private:
  struct Row {
    HalfSpace half_space;  ///< constraint on the step
    double push;           ///< its multiplier
  };
  bool is_free(const Chart& chart, const Vec6& y) const;
  /// Makes rows of the pairs that intersect at y, or nearly do.
  void gather(const Chart& chart, const Vec6& y, double margin);
  /// A step that satisfies the rows about evenly.
  Vec6 compromise();

  const Body& probe_;
  const Body& fixed_;
  Method method_;
  PhaseTimes* times_ = nullptr;
  std::vector<Violation> found_;
  std::vector<Row> rows_;
};

}  // namespace sonde
