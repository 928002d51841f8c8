// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/body/body.hpp"
#include "engine/mending/mend.hpp"

namespace sonde {

/// How the mass of a body is taken that has open parts (sheets, vessels) beside closed ones. A
/// sheet has no volume, so by volume only the closed parts would weigh anything: a tray with a
/// screw on it would turn about the screw, at no cost.
struct MassRule {
  /// Share of the area that bounds no inside, up to which the mass is the volume of the closed
  /// parts. Leaving out a share s of the area moves the centre of mass by at most 2 s R, and the
  /// mean squared displacement by a like share: so 1 % is lost in what depends on the mass anyway.
  /// A scanned solid with some stray triangles stays a solid in every number.
  double most_open = 0.01;
};
inline constexpr MassRule mass_rule;

/// The share of the area of a mended soup, without what is hidden, that bounds no inside. A sheet
/// that is there both ways round counts once.
double open_share(const Mended& mended, const std::vector<Vec3>& vertices);

/// Given a solid with its mass by volume: takes the mass by the area of its soup, where each
/// triangle counts once, if more than a negligible share of that is open. Sets mass_why, if any is.
void choose_mass(Body& body, double open_share);

}  // namespace sonde
