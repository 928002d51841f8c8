// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/base/deadline.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/penetration/contact/contact_rows.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/descent/path_length.hpp"

namespace sonde {

struct Pace;

/// Share of the depth by which a returned pose may stand off its contacts, unless the depth is
/// below 1e-5 R: there 1e-9 R is the larger.
inline constexpr double clearance_of_depth = 1e-4;
/// Largest distance from contact of a returned pose: max(1e-9 R, 1e-4·min(R, depth)), m.
double allowed_clearance(double radius, double depth);

/// When a descent has converged, and how many steps it may take.
struct DescentGoal {
  double residual = 1e-4;  ///< |y − Jᵀλ| / |y|
  int steps = 60;          ///< maximum number of iterations
  /// Units of Effort: if the effort of a run has no limit, this is its limit in all, as soon as the
  /// run is `far` (m) from its start; or the sweep of a path was given up, and the run began with
  /// |y| above `held_off` (m). 0: none.
  std::int64_t work_of_fall = 0;
  double far = 0, held_off = 0;
  bool straight_first = false;  ///< where rows turn the first step aside, the straight way is tried
  double held_slope = 0;  ///< m: loss of ½|y|² no steeper than this is not `fallen` (Outcome)
};

/// Local optimisation on the contact space, from a free pose. Each step linearises the near pairs
/// (ContactRows), solves the least-distance problem of the rows, and moves along the straight path
/// in y as far as a sweep proves it free. |y| decreases along the path, except in a step that
/// regains lost gaps at the contacts, and towards the end of one that sums up a series (Pace) or
/// mixes the last steps (StepMixing). No such step raises |y| above its value at the start of the
/// run plus one margin; the margin is the gap that the descent aims at. Every pose of the path
/// gives an upper bound of the depth. The object holds its workspace: run() never allocates.
class Descent {
 public:
  /// The gap at which a descent aims, as a share of the allowed clearance. The gap that the probe
  /// has at the end of a run depends on its path, so a probe that follows a hand around a closed
  /// path loses energy. With a half, a peg in its hole loses 0.2 % of the stored energy per loop.
  /// With a quarter, it loses less than 0.1 %, except where it leaves a local optimum, and takes as
  /// many steps. A half is enough for a search.
  static constexpr double gap_of_search = 0.5, gap_of_follower = 0.25;

  Descent(const Body& probe, const Body& fixed, Method method,
          const ContactRows::Finding& finding = {}, double gap = gap_of_search);

  struct Outcome {
    Vec6 y = Vec6::Zero();
    ContactSet contacts;
    Vec6 held = Vec6::Zero();  ///< Jᵀλ of the contacts
    double residual = 0;
    double fallen = 0;  ///< m²: part of ½|y|² lost where it fell more steeply than held_slope
    int iterations = 0;
    bool converged = false;
    /// Number of limits that acted: the maximum number of checks of a path or of steps without
    /// progress (DescentTuning), no room for more rows, or an end at the rim of the chart; and, if
    /// the descent has not converged, sweeps that took too much work.
    int limited = 0;

    void move_to(const Vec6& to) noexcept;
  };

  /// From now on, adds the time spent in each phase to `times`. Null: records no times.
  void time_into(PhaseTimes* times) noexcept { rows_.time_into(times); }
  /// Restricts all poses to a subspace (ContactRows::stay_within). Runs must begin in it.
  void stay_within(const Mat6& onto) { rows_.stay_within(onto); }
  /// Drops rows and lists. Call it before a run that is unrelated to the last one.
  void forget() noexcept;

  /// Descends from the free pose at y (in the chart of the device pose). `expected_step` is the
  /// expected distance of the answer, in m of y (0: unknown). The run checks the deadline between
  /// steps, and takes at least one step.
  Outcome run(const Chart& chart, const Vec6& y, const DescentGoal& goal, double expected_step,
              const Deadline& deadline) noexcept;
  /// The same with a limited effort, which may run out at any point, even within the first step.
  /// The path is free up to the pose at which the run stopped, but the probe need not touch
  /// anything there. The contacts of the outcome are the last ones found on the path. If the effort
  /// did not suffice to find any, they are those of the previous run, moved with the probe.
  Outcome run(const Chart& chart, const Vec6& y, const DescentGoal& goal, double expected_step,
              Effort& effort) noexcept;

  /// Works on the next neighbour list with the part of a limited effort that a run has not used.
  /// `moved`: m, by which the device moved in this tick.
  void prepare_next_list(double moved, Effort& effort) noexcept {
    rows_.prepare_next_list(moved, effort);
  }

  /// The list of pairs that the last run used; it may cover nothing.
  NeighbourList& near_list() noexcept { return rows_.list(); }

  /// Translation only: the y at which the probe comes to rest after it has turned with the device,
  /// according to the rows from the end of the last run. No value if y is not the pose at which the
  /// last run ended, or if the rows have no common point.
  std::optional<Vec6> turned_by_rows(const Chart& chart, const Vec6& y) noexcept;

  /// Sweeps the probe from y straight to another point, with half of the gap that a run aims at as
  /// the clearance.
  Sweep sweep_to(const Chart& chart, const Vec6& y, const Vec6& target, Effort& effort) noexcept;

 private:
  class Run;
  /// The multiple of the step from y whose path is not too expensive to sweep.
  double most_of_path(const Chart& chart, const Vec6& y, const Vec6& step, double margin,
                      const Pace& pace) const noexcept;
  /// m: the gap at which the descent aims. It always exceeds the rounding of coordinates, which
  /// grows with the distance from the origin.
  double margin(const Chart& chart, double depth) const noexcept;
  /// The step from y towards the solution of the rows, no longer than is worth sweeping. If
  /// contacts bend into the straight path, the step keeps `rise` (m) more gap than the rows
  /// require.
  Vec6 next_step(const Chart& chart, const Vec6& y, const LeastDistance& nearest, double margin,
                 double rise, const Pace& pace) noexcept;
  /// As sweep_to(), but given up after DescentTuning::most_work_of_sweep unless the path is of the
  /// least length.
  Sweep short_sweep_to(const Chart& chart, const Vec6& y, const Vec6& target,
                       Effort& effort) noexcept;
  /// Moves a probe that stopped away from any contact straight towards the device pose, up to the
  /// first contact. So the returned pose touches, unless a sweep there takes too much work.
  void approach_contact(const Chart& chart, double margin, Effort& effort, Outcome& out) noexcept;
  void report(Outcome& out, const Vec6& y, const LeastDistance& nearest) const noexcept;

  ContactRows rows_;
  double gap_;      // the gap aimed at, as a share of the allowed clearance
  double extents_;  // m: sum of the largest coordinates of both bodies
  PathLength path_length_;
};

}  // namespace sonde
