// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/haptics/coupling/gain_glide.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The coupling from tick to tick. It remembers the previous separation for the rates of the
/// dampers. The rates are backward differences: in the classic mode of the separation, which is
/// zero out of contact; in the damped mode of the device's pose. There are none after a reset, a
/// failed tick or a jump: the previous separation then belongs to another contact.
class Coupler {
 public:
  /// The method is that of the separations.
  explicit Coupler(const MassProperties& mass, const Coupling& coupling,
                   Method method = Method::pdg)
      : mass_(mass), method_(method), blend_{.now = coupling, .before = coupling} {}

  void set_coupling(const Coupling& coupling) noexcept {
    blend_ = {.now = coupling, .before = coupling};
  }
  /// For a change from one mode to another: two sets of gains.
  void set_coupling(const GainGlide::Blend& blend) noexcept { blend_ = blend; }
  const Coupling& coupling() const noexcept { return blend_.now; }
  /// Call it before a separation that is unrelated to the previous one.
  void forget() noexcept { has_motion_ = false; }
  /// The wrench of the next separation, within the limits of the coupling; zero if it failed. dt is
  /// the time since the last one, s; 0 if unknown, and then there is no damping.
  Wrench wrench(const Separation& separation, double dt) noexcept;

 private:
  Wrench unlimited(const Coupling& coupling, const Separation& separation,
                   const SeparationMotion& now, double dt) const noexcept;
  Wrench classic(const Coupling& coupling, const SeparationMotion& now, double dt) const noexcept;

  MassProperties mass_;
  Method method_;
  GainGlide::Blend blend_;
  SeparationMotion motion_;  ///< of the last tick
  Pose device_;              ///< the same
  bool has_motion_ = false;  ///< they belong to the same contact as the next separation
};

}  // namespace sonde
