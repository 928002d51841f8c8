// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/penetration/search/static_search.hpp"

namespace sonde {

/// Follows the separated pose of a moving probe: each tick's Q is reached from the last along a
/// path swept free, on which σ to the new device pose never rises, and ends at a KKT point (or at
/// the end of the budget, and says so).
class CoherentSolver {
 public:
  explicit CoherentSolver(const Pair& pair, Method method = Method::pdg);
  ~CoherentSolver();
  CoherentSolver(CoherentSolver&&) noexcept;
  CoherentSolver& operator=(CoherentSolver&&) noexcept;

  /// Starts at X_FM: free there, or a static search where the probe overlaps. Allocates; not for
  /// the servo thread. The result is marked as jumped where a search was needed.
  const Separation& reset(const Pose& X_FM, const StaticOptions& options = {});

  /// The next device pose. Never allocates, locks, logs or throws. Before the first reset the
  /// result is failed; a pose that is not finite is refused (failed) and changes nothing.
  const Separation& tick(const Pose& X_FM, const Budget& budget = {}) noexcept;

  const Separation& last() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
