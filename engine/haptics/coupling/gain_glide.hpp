// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// Moves the gains smoothly to their new values. In a contact the force is a multiple of the gains,
/// so gains that jump would knock at the hand. Stiffness, damping, and limits that rise move in a
/// straight line over `time`; limits that fall act at once. The gains of another mode have another
/// meaning: there the wrench moves, in the same time, from the wrench of the old mode to that of
/// the new one. Changes during that time wait for its end, except limits that fall. It may go more
/// slowly, so that the force does not move faster than a hand can bear.
class GainGlide {
 public:
  struct Blend {
    Coupling now;      ///< limits included
    Coupling before;   ///< gains of the old mode; valid where share < 1
    double share = 1;  ///< share of `now` in the wrench
  };

  /// `time` in s; zero: no glide.
  explicit GainGlide(const Coupling& coupling, double time = 0.1)
      : time_(time), from_(coupling), to_(coupling), blend_{.now = coupling, .before = coupling} {}

  /// Without a glide.
  void restart(const Coupling& coupling) noexcept;
  /// Starts a glide from the present gains; the newest call wins.
  void set(const Coupling& wanted) noexcept;
  /// The gains dt (s) later; no more than `most` of the way, a share, is made of it.
  const Blend& next(double dt, double most = 1) noexcept;
  /// The ends of the way; the same where there is none to go.
  const Coupling& from() const noexcept { return there_ ? to_ : from_; }
  const Coupling& to() const noexcept { return to_; }
  /// The share of it that is made.
  double made() const noexcept { return there_ ? 1 : share_; }

 private:
  void blend(double share) noexcept;

  double time_;
  double share_ = 0;  ///< of the way that is made
  bool there_ = true;
  Coupling from_, to_;
  std::optional<Coupling> next_;  ///< the newest change that waits for the end of a change of mode
  Blend blend_;
};

}  // namespace sonde
