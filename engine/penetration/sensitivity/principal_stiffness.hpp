// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "engine/penetration/sensitivity/wrench_derivative.hpp"

namespace sonde {

/// A direction and how stiff the hand feels it.
struct PrincipalStiffness {
  double value = 0;               ///< N/m along the direction, or N·m/rad about it
  Vec3 direction = Vec3::Zero();  ///< unit, in the fixed body's mesh frame
};

/// The stiffness that the hand feels, by its principal directions: the largest first.
struct PrincipalStiffnesses {
  std::array<PrincipalStiffness, 3> translation;  ///< N/m: displaced without a turn
  std::array<PrincipalStiffness, 3> rotation;     ///< N·m/rad: turned about the centre of mass
};

/// Of the object norm with the gain k (N/m): the eigenvectors of the two symmetric parts of
/// −k ∂(F, τ)/∂(δx, δφ). (The force that a turn makes, and the torque that a displacement makes,
/// are in neither.)
/// @pre The derivative has a side, k is finite.
PrincipalStiffnesses principal_stiffnesses(const WrenchDerivative& derivative, double k) noexcept;

static_assert(sizeof(PrincipalStiffness) == 32 && alignof(PrincipalStiffness) == 8);
static_assert(offsetof(PrincipalStiffness, direction) == 8);
static_assert(sizeof(PrincipalStiffnesses) == 192 &&
              offsetof(PrincipalStiffnesses, rotation) == 96);

}  // namespace sonde
