// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "engine/penetration/sensitivity/wrench_derivative.hpp"

namespace sonde {

/// A direction and the stiffness that the hand feels in it.
struct PrincipalStiffness {
  double value = 0;               ///< N/m along the direction, or N·m/rad about it
  Vec3 direction = Vec3::Zero();  ///< unit, in the fixed body's mesh frame
};

/// The stiffness that the hand feels, in its principal directions, the largest first.
struct PrincipalStiffnesses {
  std::array<PrincipalStiffness, 3> translation;  ///< N/m: displacement without a turn
  std::array<PrincipalStiffness, 3> rotation;     ///< N·m/rad: turn about the centre of mass
};

/// For the object norm with the gain k (N/m): the eigenvectors of the symmetric parts of the two
/// diagonal blocks of −k ∂(F, τ)/∂(δx, δφ). (Neither contains the force caused by a turn, nor the
/// torque caused by a displacement.)
/// @pre The derivative has a side, k is finite.
PrincipalStiffnesses principal_stiffnesses(const WrenchDerivative& derivative, double k) noexcept;

static_assert(sizeof(PrincipalStiffness) == 32 && alignof(PrincipalStiffness) == 8);
static_assert(offsetof(PrincipalStiffness, direction) == 8);
static_assert(sizeof(PrincipalStiffnesses) == 192 &&
              offsetof(PrincipalStiffnesses, rotation) == 96);

}  // namespace sonde
