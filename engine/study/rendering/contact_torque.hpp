// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/penetration/contact/contact_rows.hpp"

namespace sonde {

/// The torque of a translational separation, PD_t, from its contacts. The motion t itself has none.
/// But the separated pose turns with the device, and a turn against its contacts changes the depth:
/// U = ½k|t|² gives F = kt = kΣλᵢnᵢ and τ = kΣλᵢ rᵢ×nᵢ.
///
/// If there are more contacts than t needs (a face on a face), many λ give the same t. Of these,
/// the multipliers with the least torque are chosen: the steadiest choice, so that the comparison
/// shows PD_t at its best. This is the least-distance problem of all contacts within the solver's
/// clearance, with turns weighted by a ten-thousandth: enough for a unique choice, too little to
/// change t.
class ContactTorque {
 public:
  ContactTorque(const Body& probe, const Body& fixed);

  /// Σλᵢ rᵢ×nᵢ about the probe's centre of mass, fixed frame, m²; zero out of contact. (The centre
  /// of mass at the separated pose and at the device pose are equivalent: the force acts along the
  /// line between them.)
  Vec3 at(const Separation& separation);

 private:
  const Body& probe_;
  ContactRows rows_;
  std::vector<HalfSpace> half_spaces_;
};

}  // namespace sonde
