// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// Gains on their way to those that were asked for: at one contact the force is a multiple of the
/// gains, so gains that jump would knock at the hand. Stiffness, damping, and limits that rise go
/// in a straight line over `time`; limits that fall do so at once. The gains of another mode mean
/// something else: there the wrench is to go, in the same time, from that of the mode before to
/// that of the new one. What is asked for on that way waits for its end, all but limits that fall.
class GainGlide {
 public:
  struct Blend {
    Coupling now;      ///< limits included
    Coupling before;   ///< of the mode before; to be had where share < 1
    double share = 1;  ///< of `now` in the wrench
  };

  /// `time` in s; zero: no glide.
  explicit GainGlide(const Coupling& coupling, double time = 0.1)
      : time_(time), from_(coupling), to_(coupling), blend_{.now = coupling, .before = coupling} {}

  /// Without a glide.
  void restart(const Coupling& coupling) noexcept;
  /// From the gains of now on; the newest wins.
  void set(const Coupling& wanted) noexcept;
  /// The gains dt (s) later.
  const Blend& next(double dt) noexcept;

 private:
  void blend(double share) noexcept;

  double time_;
  double since_ = 0;  ///< s, of the glide
  bool there_ = true;
  Coupling from_, to_;
  std::optional<Coupling> next_;  ///< the newest asked for on the way to another mode
  Blend blend_;
};

}  // namespace sonde
