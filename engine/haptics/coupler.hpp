// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling.hpp"
#include "engine/penetration/separation.hpp"

namespace sonde {

/// The coupling from tick to tick: it remembers the separation before for the rates of the classic
/// mode. They are backward differences of the separation, which is zero out of contact. There are
/// none after a reset, a failed tick or a jump: the separation before belongs to another contact.
class Coupler {
 public:
  Coupler(const MassProperties& mass, const Coupling& coupling)
      : mass_(mass), coupling_(coupling) {}

  void set_coupling(const Coupling& coupling) noexcept { coupling_ = coupling; }
  const Coupling& coupling() const noexcept { return coupling_; }
  /// The next separation has nothing to do with the one before.
  void forget() noexcept { has_motion_ = false; }
  /// The wrench of the next separation, within the limits of the coupling; zero where it failed.
  /// dt in s since the last one; 0 where that is not known, and then nothing is damped.
  Wrench wrench(const Separation& separation, double dt) noexcept;

 private:
  Wrench classic(const SeparationMotion& now, double dt) const noexcept;

  MassProperties mass_;
  Coupling coupling_;
  SeparationMotion motion_;  ///< of the last tick
  bool has_motion_ = false;  ///< the next separation may be compared with `motion_`
};

}  // namespace sonde
