// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling.hpp"

namespace sonde {

/// Gains on their way to those that were asked for: at one contact the force is a multiple of the
/// gains, so gains that jump would knock at the hand. Stiffness and damping go in a straight line
/// over `time`; mode and limits are at once what was asked for, and with another mode, whose gains
/// mean something else, all of it is.
class GainGlide {
 public:
  /// `time` in s; zero: no glide.
  explicit GainGlide(const Coupling& coupling, double time = 0.1)
      : time_(time), from_(coupling), to_(coupling), now_(coupling) {}

  /// Without a glide.
  void restart(const Coupling& coupling) noexcept;
  /// From the gains of now on.
  void set(const Coupling& wanted) noexcept;
  /// The gains dt (s) later.
  const Coupling& next(double dt) noexcept;

 private:
  double time_;
  double since_ = 0;  ///< s, of the glide
  bool there_ = true;
  Coupling from_, to_, now_;
};

}  // namespace sonde
