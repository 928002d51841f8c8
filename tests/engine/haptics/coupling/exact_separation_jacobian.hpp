// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/chart.hpp"

namespace sonde::test {

/// How y follows the device with the bending of its contacts: the rows are the components of y, the
/// columns those of the device's velocity. `d_separated` is the derivative of Q with respect to O
/// (WrenchDerivative), which has its own references.
inline Mat6 exact_separation_jacobian(const MassProperties& mass, const Pose& X_FO,
                                      const Pose& X_FQ, const Mat6& d_separated) {
  const Chart chart(mass, X_FO);
  Quat turn = chart.principal().conjugate() * (X_FQ.q * Quat(mass.R_MP));
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  Mat3 cross;
  cross << 0, -turn.z(), turn.y(), turn.z(), 0, -turn.x(), -turn.y(), turn.x(), 0;
  // Of Q seen from O; a turn's quaternion changes by half of the rate times itself.
  const Mat6 relative = d_separated - Mat6::Identity();
  const Mat3 v_rate =
      (turn.w() * Mat3::Identity() - cross) / 2 * chart.principal().toRotationMatrix().transpose();
  const Vec3 root = 2 * mass.inertia.cwiseSqrt();
  Mat6 out;
  out.topRows<3>() = root.asDiagonal() * v_rate * relative.bottomRows<3>();
  out.bottomRows<3>() = relative.topRows<3>();
  return out;
}

}  // namespace sonde::test
