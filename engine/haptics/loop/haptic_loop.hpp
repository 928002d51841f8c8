// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/search/static_search.hpp"

namespace sonde {

/// The loop with geometry and force in the same tick, without thread or clock. `replay` runs it,
/// and it is the reference for the decoupled loop of the servo (hand_loop.hpp).
class HapticLoop {
 public:
  HapticLoop(const Pair& pair, Method method, const Coupling& coupling);
  ~HapticLoop();
  HapticLoop(HapticLoop&&) noexcept;
  HapticLoop& operator=(HapticLoop&&) noexcept;

  /// Starts at the first pose: it is free, or a static search (by this loop's method) finds the
  /// separated pose. Allocates. Afterwards wrench() is that of this pose, without damping.
  void reset(const Pose& X_FM, const StaticOptions& options);
  void set_coupling(const Coupling& coupling) noexcept;
  /// dt is the time since the last tick, s (for the rates of the dampers, see Coupler); 0 if
  /// unknown, and then there is no damping. No allocation, lock, log, throw.
  void tick(const Pose& X_FM, double dt, const Budget& budget) noexcept;
  /// Whether a tick reports where its time went (Separation::phases), from the next one on.
  void time_phases(bool on) noexcept;
  const Separation& separation() const;
  const Wrench& wrench() const;  ///< zero if the separation failed

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
