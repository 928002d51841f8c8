// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/search/static_search.hpp"

namespace sonde {

/// One tick of the loop in step: geometry and force in one, with no thread and no clock. What
/// `replay` runs, and what the decoupled loop of the servo (hand_loop.hpp) is measured against.
class HapticLoop {
 public:
  HapticLoop(const Pair& pair, Method method, const Coupling& coupling);
  ~HapticLoop();
  HapticLoop(HapticLoop&&) noexcept;
  HapticLoop& operator=(HapticLoop&&) noexcept;

  /// First pose: free, or a static search (by this loop's method). Allocates. Leaves the wrench of
  /// that pose, without damping.
  void reset(const Pose& X_FM, const StaticOptions& options);
  void set_coupling(const Coupling& coupling) noexcept;
  /// dt in s since the last tick (for the rates of the classic mode, see Coupler); 0 where that is
  /// not known, and then nothing is damped. No allocation, lock, log, throw.
  void tick(const Pose& X_FM, double dt, const Budget& budget) noexcept;
  const Separation& separation() const;
  const Wrench& wrench() const;  ///< zero where the separation failed

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
