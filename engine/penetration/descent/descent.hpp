// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/base/deadline.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/penetration/contact/contact_rows.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// How near a returned pose may lie to contact: max(1e-9 R, 1e-4·min(R, depth)), m.
double allowed_clearance(double radius, double depth);

/// When a descent is good enough.
struct DescentGoal {
  double residual = 1e-4;  ///< |y − Jᵀλ| / |y|
  int steps = 60;          ///< iterations at most
};

/// Local optimisation on the contact space: from a free pose, linearise the near pairs, solve the
/// least-distance problem of the rows, go along the straight path in y as far as it is swept free,
/// repeat. |y| never rises along the path, so every pose on it is an upper bound. Holds its own
/// workspace: run() never allocates.
class Descent {
 public:
  /// The gaps aimed at, in parts of the clearance allowed. How far within it a probe stands depends
  /// on the way that it came, and costs energy where it follows a hand: with a half, 0.2 % of what
  /// a peg in its hole stores in a loop; with a quarter, less than 0.1 % but where it lets go of a
  /// place, in as many steps. A search gets by with the half.
  static constexpr double gap_of_search = 0.5, gap_of_follower = 0.25;

  Descent(const Body& probe, const Body& fixed, Method method,
          const ContactRows::Finding& finding = {}, double gap = gap_of_search);

  struct Outcome {
    Vec6 y = Vec6::Zero();
    ContactSet contacts;
    Vec6 held = Vec6::Zero();  ///< Jᵀλ of the contacts
    double residual = 0;
    int iterations = 0;
    bool converged = false;
    /// Limits that acted: steps that one on looks or on fruitless steps cut short (DescentTuning),
    /// and looks after which there was no room for more rows.
    int limited = 0;

    void move_to(const Vec6& to) noexcept;
  };

  /// What comes next has nothing to do with what was run before.
  void forget() noexcept;

  /// From the free pose at y (in the chart of the device pose). `expected_step`: how far, in y, the
  /// answer is thought to lie (0: unknown). The deadline is looked at between steps, of which one
  /// is always taken.
  Outcome run(const Chart& chart, const Vec6& y, const DescentGoal& goal, double expected_step,
              const Deadline& deadline) noexcept;
  /// The effort may end anywhere, also within the first step. The path is free up to where the run
  /// stopped; it may be away from any contact, and the contacts are those last found: on the way,
  /// or where there was no effort to look at all, those of the run before, moved with the probe.
  Outcome run(const Chart& chart, const Vec6& y, const DescentGoal& goal, double expected_step,
              Effort& effort) noexcept;

  /// After a run with a limited effort: what it leaves over is used for the next ones.
  void look_ahead(Effort& effort) noexcept { rows_.look_ahead(effort); }

  /// Translation only: where the probe, turned as the device is, comes to rest by the rows of where
  /// the last run ended. None where y is not there.
  std::optional<Vec6> turned_by_rows(const Chart& chart, const Vec6& y) noexcept;

  /// Sweeps the probe from y straight to another point, with half of the gap that a run leaves.
  Sweep sweep_to(const Chart& chart, const Vec6& y, const Vec6& target, Effort& effort) noexcept;

 private:
  struct Pace;
  /// The gap aimed at, m; never so little that the rounding of coordinates, far from the origin,
  /// could eat it up.
  double margin(const Chart& chart, double depth) const noexcept;
  /// From y towards the nearest point of the rows, as far as it is worth while to go in one step;
  /// with contacts that bend into it, so much (m) above it.
  Vec6 next_step(const Chart& chart, const Vec6& y, const LeastDistance& nearest, double margin,
                 double rise, const Pace& pace) noexcept;
  /// Stopped on the way, away from any contact: straight on towards the device pose to the first
  /// one, so that what is returned touches.
  void close_up(const Chart& chart, double margin, Effort& effort, Outcome& out) noexcept;
  Outcome run(const Chart& chart, const Vec6& y, const DescentGoal& goal, double expected_step,
              const Deadline& deadline, Effort& effort) noexcept;
  void report(Outcome& out, const Vec6& y, const LeastDistance& nearest) const noexcept;

  ContactRows rows_;
  double gap_;           // aimed at, in parts of the clearance allowed
  double extents_;       // of both bodies, m
  double longest_path_;  // m: no path is longer, since a sweep of such took all of the effort
};

}  // namespace sonde
