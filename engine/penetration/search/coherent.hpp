// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/static_options.hpp"

namespace sonde {

class NeighbourList;

/// Follows the separated pose of a moving probe. Each tick moves Q from the last separated pose
/// along a path that sweeps prove free. On this path, the distance √σ to the new device pose
/// decreases, except where the probe regains its gaps, and towards the end of a step that sums up a
/// series of steps: it never exceeds its value at the start of the tick by more than a quarter of
/// the allowed clearance. The path ends at a KKT point, or when the budget is spent; the result
/// says which.
class CoherentSolver {
 public:
  explicit CoherentSolver(const Pair& pair, Method method = Method::pdg);
  ~CoherentSolver();
  CoherentSolver(CoherentSolver&&) noexcept;
  CoherentSolver& operator=(CoherentSolver&&) noexcept;
  /// The copy continues from the same state, with the same bits. Allocates.
  CoherentSolver(const CoherentSolver&);
  CoherentSolver& operator=(const CoherentSolver&);

  /// Starts at X_FM. If the probe is free there, X_FM is the separated pose; otherwise a static
  /// search finds it, and the result is marked as jumped. Allocates; not for the servo thread.
  /// Throws Cancelled if `progress` returns false; the state is then unchanged.
  const Separation& reset(const Pose& X_FM, const StaticOptions& options = {},
                          const Progress& progress = {});

  /// Follows to the next device pose. Never allocates, locks, logs or throws. Before the first
  /// reset the result is failed. A pose that is not finite is refused (failed) and changes nothing.
  const Separation& tick(const Pose& X_FM, const Budget& budget = {}) noexcept;

  /// Whether ticks report where their time went (Separation::phases), from the next one on.
  void time_phases(bool on) noexcept;

  const Separation& last() const;

  /// The solver's list of the pairs near the separated pose, for other looks there until the next
  /// tick. It may cover nothing.
  NeighbourList& near_list() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
