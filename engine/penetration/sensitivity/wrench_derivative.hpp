// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "engine/geometry/pose.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// How the depth and the wrench of a separation change with the given pose O, where the separated
/// pose Q follows it as the nearest free pose near by.
///
/// A small motion of O is (δx, δφ): the displacement of the probe's centre of mass, m, and a
/// rotation vector, rad, both in the fixed body's mesh frame F. The wrench is (F, τ), the force on
/// the hand and the torque about the probe's centre of mass at O, in F, of the object norm at k = 1
/// (U = ½σ): for a gain of k, times k. So −k·d_wrench is the stiffness that the hand feels.
struct WrenchDerivative {
  /// 6 × 6, or 6 × 1, by columns, not aligned.
  using Matrix = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;
  using Vector = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;  ///< As Matrix.

  /// Where the derivative holds: on all sides of this pose (all); on one side, with another
  /// derivative on the other side (two); or nowhere (none).
  enum class Sides { all, two, none };
  Sides sides = Sides::none;  ///< where this one holds
  int rows = 0;               ///< number of independent features that hold the probe on this side
  /// Why the derivative does not hold on all sides; static text, empty if it does.
  const char* reason = "";
  Vector d_depth = Vector::Zero();   ///< ∂depth/∂(δx, δφ): 1 and m/rad
  Matrix d_wrench = Matrix::Zero();  ///< ∂(F, τ)/∂(δx, δφ) at k = 1
  /// The motion of Q, as (displacement of the centre of mass, rotation vector), on the side of
  /// `d_wrench`.
  Matrix d_separated = Matrix::Zero();
  /// If there are two sides: the derivative on the other side, where contacts hold that `d_wrench`
  /// leaves out. (The depth has the same derivative on both.) Otherwise equal to d_wrench.
  Matrix d_wrench_held = Matrix::Zero();
  /// If there are two sides: a motion m of O with leaves·m > 0 leads to the side of `d_wrench`, one
  /// with leaves·m < 0 to that of `d_wrench_held`. (If several contacts are about to begin or to
  /// end, this is the first of them; the regions in between are ignored.) Otherwise 0.
  Vector leaves = Vector::Zero();
};

/// Where to search for features that are about to hold the probe.
enum class Neighbours {
  of_contacts,  ///< at the contacts of the separation: for a tick
  all           ///< everywhere within the clearance: one more query of near pairs
};

/// The derivative of a separation with Method::pdg, in closed form: from the curvature of σ and of
/// the gaps that hold the probe, which are gaps of the vertices, edges and faces at its contacts.
/// The separated pose stands off its contacts by the clearance, so the probe is first moved into
/// contact; the derivative is that of the exact optimum there. Contacts whose multiplier or gap is
/// below the accuracy of the separation (its clearance) make two sides. There is no derivative if
/// the search failed or has not converged, if the probe only touches, if the optimum is not strict
/// (a turn that changes nothing), or if features touch that have no normal of their own, such as
/// two corners. If the probe is free, the derivative is 0. Neither allocates, locks, logs nor
/// throws.
/// @pre `now` is a result of this pair.
WrenchDerivative wrench_derivative(const Pair& pair, const Separation& now,
                                   Neighbours neighbours = Neighbours::of_contacts) noexcept;

static_assert(sizeof(WrenchDerivative::Matrix) == 288 && alignof(WrenchDerivative::Matrix) == 8);
static_assert(sizeof(void*) != 8 ||
              (sizeof(WrenchDerivative) == 976 && alignof(WrenchDerivative) == 8 &&
               offsetof(WrenchDerivative, reason) == 8 &&
               offsetof(WrenchDerivative, d_depth) == 16 &&
               offsetof(WrenchDerivative, d_wrench) == 64 &&
               offsetof(WrenchDerivative, d_separated) == 352 &&
               offsetof(WrenchDerivative, d_wrench_held) == 640 &&
               offsetof(WrenchDerivative, leaves) == 928));

}  // namespace sonde
