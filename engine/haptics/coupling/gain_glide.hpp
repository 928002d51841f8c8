// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/haptics/coupling/coupling.hpp"

namespace sonde {

/// Moves the gains smoothly to their new values. In a contact the force is proportional to the
/// gains, so a jump of the gains would give the hand a jolt. Stiffness, damping, and rising limits
/// move in a straight line over `time`; falling limits act immediately. The object norm is the
/// damped mode without damping. The gains of the classic mode have other meanings. So in a change
/// to it or from it, the wrench is blended, in the same time, from that of the old mode to that of
/// the new one. Other changes during that time wait for its end, except falling limits. A caller
/// may slow the glide down, so that the force does not change faster than a hand can resist, or
/// hold it. If a change of mode is held while another change waits for its end, the glide reverses,
/// once. If the reversed glide is held too, both changes wait.
class GainGlide {
 public:
  struct Blend {
    Coupling now;      ///< gains now, with the limits
    Coupling before;   ///< gains of the old mode; valid if share < 1
    double share = 1;  ///< share of `now` in the wrench
  };

  /// `time` in s; zero: no glide.
  explicit GainGlide(const Coupling& coupling, double time = 0.1)
      : time_(time), from_(coupling), to_(coupling), blend_{.now = coupling, .before = coupling} {}

  /// Sets the gains without a glide.
  void restart(const Coupling& coupling) noexcept;
  /// Starts a glide from the present gains; the newest call wins.
  void set(const Coupling& wanted) noexcept;
  /// Advances by dt (s) and returns the gains. The step covers at most the share `most` of the
  /// whole glide; 0 holds it.
  const Blend& next(double dt, double most = 1) noexcept;
  /// The start and the end of the glide; equal if there is none.
  const Coupling& from() const noexcept { return arrived_ ? to_ : from_; }
  const Coupling& to() const noexcept { return to_; }
  /// The share of the glide that is done.
  double made() const noexcept { return arrived_ ? 1 : share_; }

 private:
  void blend(double share) noexcept;
  void turn_back() noexcept;

  double time_;
  double share_ = 0;  ///< share of the glide that is done
  bool arrived_ = true;
  bool turned_back_ = false;  ///< this change of mode has been reversed
  Coupling from_, to_;
  std::optional<Coupling> next_;  ///< the newest change that waits for the end of a change of mode
  Blend blend_;
};

}  // namespace sonde
