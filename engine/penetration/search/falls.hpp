// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/penetration/descent/descent.hpp"

namespace sonde {

/// Tells which ticks of a coherent solver let energy go: those that leave a local optimum, and
/// those in which a probe that is behind catches up. Energies are in m² of σ; ½ k times that is in
/// J.
class Falls {
 public:
  explicit Falls(Method method) : turns_(method == Method::pdg) {}

  /// Forgets the last ticks. The next one follows a search, which leaves all of the clearance.
  void forget() noexcept { *this = Falls(turns_ ? Method::pdg : Method::pdt); }

  /// m: no probe that stays held descends more steeply in a tick in which the device moves by
  /// `moved` (m): as much as the device has moved since the last tick that converged.
  double held_slope(double moved) const noexcept;

  struct Tick {
    double moved = 0;      ///< m: motion of the device
    double way = 0;        ///< m: motion of the separated probe
    double before = 0;     ///< m: depth of the tick before
    double depth = 0;      ///< m
    double clearance = 0;  ///< m: allowed above contacts at the depth before
    double let_go = 0;     ///< m²: what neither is stored nor was given back to the hand
    double fallen = 0;     ///< m²: Descent::Outcome::fallen beyond held_slope()
    bool converged = false;
  };
  struct Release {
    double energy = 0;    ///< m²: Separation::released
    bool lagged = false;  ///< Separation::lagged
  };
  /// What a tick that jumped let go (Separation::jumped); none if it did not jump.
  std::optional<Release> released(const Tick& tick) noexcept;

 private:
  bool fell(const Tick& tick) const noexcept;
  bool let_go_behind(const Tick& tick) noexcept;

  bool turns_;
  /// Share of the allowed clearance: the largest distance of the last pose above its contacts.
  double gap_ = 1;
  double lag_ = 0;     // m: motion of the device since the last tick that converged
  double unsaid_ = 0;  // m²: let go since then in ticks that did not say so
};

}  // namespace sonde
