// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupling/object_damper.hpp"

namespace sonde {
namespace {

Mat3 cross_matrix(const Vec3& v) {
  Mat3 out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

}  // namespace

Mat6 separation_jacobian(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ,
                         const Mat6& d_separated) {
  const Chart chart(mass, X_FO);
  Quat turn = chart.principal().conjugate() * (X_FQ.q * Quat(mass.R_MP));
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  // Of Q seen from O; a turn's quaternion changes by half of the rate times itself.
  const Mat6 relative = d_separated - Mat6::Identity();
  const Mat3 v_rate = (turn.w() * Mat3::Identity() - cross_matrix(turn.vec())) / 2 *
                      chart.principal().toRotationMatrix().transpose();
  const Vec3 root = 2 * mass.inertia.cwiseSqrt();
  Mat6 out;
  out.topRows<3>() = root.asDiagonal() * v_rate * relative.bottomRows<3>();
  out.bottomRows<3>() = relative.topRows<3>();
  return out;
}

Wrench object_damper(const Mat6& jacobian, const Vec6& rate, double damping) {
  const Vec6 wrench = -damping * jacobian.transpose() * rate;
  Wrench out;
  out.force = wrench.head<3>();
  out.torque = wrench.tail<3>();
  return out;
}

}  // namespace sonde
