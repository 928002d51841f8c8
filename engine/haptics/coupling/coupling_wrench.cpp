// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupling/coupling_wrench.hpp"

#include <algorithm>
#include <cmath>

#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// The rotation from O to Q, by at most half a turn.
Quat relative_rotation(const Pose& X_FO, const Pose& X_FQ) {
  Quat q = X_FO.q.conjugate() * X_FQ.q;
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return q;
}

Vec3 displacement_of_com(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) {
  return X_FQ * mass.com - X_FO * mass.com;
}

/// Scales x down to the limit. A value that is not a number must never reach a hand: it becomes
/// zero.
Vec3 scaled_down(const Vec3& x, double maximum, bool& acted) {
  const double length = x.stableNorm();
  if (length <= maximum) return x;
  acted = true;
  if (!std::isfinite(length) || !(maximum > 0)) return Vec3::Zero();
  return x * (maximum / length);
}

}  // namespace

SeparationMotion separation_motion(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) {
  return {displacement_of_com(mass, X_FO, X_FQ),
          X_FO.q * rotation_vector(relative_rotation(X_FO, X_FQ))};
}

Wrench object_norm_wrench(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ,
                          double k) {
  const Quat q_rel = relative_rotation(X_FO, X_FQ);
  const Vec3 v = mass.R_MP.transpose() * q_rel.vec();
  const Vec3 Iv = mass.inertia.cwiseProduct(v);
  // The sign of the cross term is that for the axes at O; for those at Q it is the opposite.
  const Vec3 torque_P = 2 * k * (q_rel.w() * Iv + v.cross(Iv));
  Wrench out;
  out.force = k * displacement_of_com(mass, X_FO, X_FQ);
  out.torque = X_FO.q * (mass.R_MP * torque_P);
  return out;
}

Wrench classic_wrench(const SeparationMotion& now, const Vec3& t_rate, const Vec3& theta_rate,
                      const Coupling& coupling) {
  Wrench out;
  out.force = coupling.k_t * now.t + coupling.b_t * t_rate;
  out.torque = coupling.k_r * now.theta + coupling.b_r * theta_rate;
  return out;
}

Wrench limit(const Wrench& wrench, double max_force, double max_torque) {
  Wrench out;
  out.saturated = wrench.saturated;
  out.force = scaled_down(wrench.force, max_force, out.saturated);
  out.torque = scaled_down(wrench.torque, max_torque, out.saturated);
  return out;
}

double stiffness_of_lag(const Coupling& c, const MassProperties& mass) noexcept {
  if (in_object_norm(c.mode)) return c.k;
  // Near the device pose a lag is a turn of at most its size over the least radius of gyration
  // about which one turns.
  double least = mass.inertia.maxCoeff();
  if (!(least > 0)) return c.k_t;  // a point: it does not turn
  const double largest = least;
  for (const double inertia : mass.inertia)
    if (inertia > 0) least = std::min(least, inertia);
  return std::max(c.k_t, c.k_r / std::sqrt(least * largest));
}

Vec3 towards(const Vec3& wanted, const Vec3& last, double most, bool* limited) noexcept {
  const Vec3 change = wanted - last;
  const double size = change.norm();
  if (size <= most) return wanted;
  if (limited) *limited = true;
  return last + change * (most / size);
}

}  // namespace sonde
