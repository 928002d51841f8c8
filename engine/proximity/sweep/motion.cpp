// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/motion.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/elementary.hpp"

namespace sonde {
namespace {

/// The matrix of x × (·).
Mat3 times(const Vec3& x) {
  Mat3 m;
  m << 0, -x.z(), x.y(), x.z(), 0, -x.x(), -x.y(), x.x(), 0;
  return m;
}

}  // namespace

Motion::Motion(const Chart& chart, const Vec6& from, const Vec6& to)
    : q_FP_(chart.principal()),
      q_PM_(Quat(chart.mass().R_MP).conjugate()),
      com_M_(chart.mass().com),
      com_from_(chart.com() + from.tail<3>()),
      com_step_(to.tail<3>() - from.tail<3>()),
      v_from_(chart.v(from)),
      v_step_(chart.v(to) - chart.v(from)) {
  // With q = (w, v(s)): ẇ = −v·v̇/w and ẅ = −(|v̇|² + ẇ²)/w; |ω| = 2|q̇| and |ω̇| ≤ 2|q̈| = 2|ẅ|.
  // |v(s)| is largest at an end of the path.
  const double v2 = std::max(v_from_.squaredNorm(), (v_from_ + v_step_).squaredNorm());
  const double w2 = std::max(least_w2, 1 - v2);
  const double step2 = v_step_.squaredNorm();
  const double q2 = step2 + step2 * v2 / w2;
  turn_ = 2 * std::sqrt(q2) * (1 + 1e-12);
  acceleration_ = (4 * q2 + 2 * q2 / std::sqrt(w2)) * (1 + 1e-12);
  // A turned arm is r + 2w v×r + 2 v×(v×r). Its third derivative is 2w‴ v×r + 6w″ v̇×r, with |w″| ≤
  // |v̇|²/w³ and |w‴| ≤ 3|v||v̇|³/w⁵, together at most 6|v̇|³|r|/w⁵; bend_ is taken half-way, at
  // half of the path from either end.
  const Vec3 half = v_from_ + 0.5 * v_step_;
  const double w = std::sqrt(std::max(least_w2, 1 - half.squaredNorm()));
  const double w1 = -half.dot(v_step_) / w, w11 = -(step2 + w1 * w1) / w;
  const Mat3 in_probe =
      2 * w11 * times(half) + 4 * w1 * times(v_step_) + 4 * times(v_step_) * times(v_step_);
  bend_ = q_FP_.toRotationMatrix() * in_probe * q_PM_.toRotationMatrix();
  bend_error_ = 3 * step2 * std::sqrt(step2) / (w2 * w2 * std::sqrt(w2)) + 1e-12 * acceleration_;
}

Motion::Motion(const MassProperties& mass, const Pose& from, const Pose& to)
    : q_FP_((from.q * Quat(mass.R_MP)).normalized()),
      q_PM_(Quat(mass.R_MP).conjugate()),
      com_M_(mass.com),
      com_from_(from * mass.com),
      com_step_(to * mass.com - com_from_),
      v_from_(Vec3::Zero()),
      v_step_(Vec3::Zero()) {
  Quat turn = q_FP_.conjugate() * to.q * Quat(mass.R_MP);
  if (turn.w() < 0) turn.coeffs() = -turn.coeffs();
  const double half_sine = turn.vec().norm();
  steady_ = 2 * elementary::atan2(half_sine, turn.w());
  if (half_sine > 0) axis_ = turn.vec() / half_sine;
  turn_ = steady_ * (1 + 1e-12);
  // An arm turns as R″ = ω² [axis]² R, and |R‴| = ω³; the middle is half of the path from either
  // end.
  const double squared = steady_ * steady_;
  acceleration_ = squared * (1 + 1e-12);
  bend_ = q_FP_.toRotationMatrix() * (squared * times(axis_) * times(axis_)) *
          relative(0.5).toRotationMatrix() * q_PM_.toRotationMatrix();
  bend_error_ = 0.5 * squared * steady_ + 1e-12 * acceleration_;
}

Quat Motion::relative(double s) const {
  if (steady_ > 0) {
    const Vec3 u = elementary::sin(0.5 * s * steady_) * axis_;
    return {elementary::cos(0.5 * s * steady_), u.x(), u.y(), u.z()};
  }
  const Vec3 u = v_from_ + s * v_step_;
  return {std::sqrt(std::max(0.0, 1 - u.squaredNorm())), u.x(), u.y(), u.z()};
}

Transform Motion::at(double s) const {
  const Quat q = (q_FP_ * relative(s) * q_PM_).normalized();
  const Mat3 R = q.toRotationMatrix();
  return {R, com_from_ + s * com_step_ - R * com_M_};
}

Pose Motion::pose_at(double s) const {
  const Quat q = (q_FP_ * relative(s) * q_PM_).normalized();
  return {q, com_from_ + s * com_step_ - q.toRotationMatrix() * com_M_};
}

Motion::Velocity Motion::velocity(double s) const {
  if (steady_ > 0) return {com_step_, q_FP_ * (steady_ * axis_)};
  const Quat turn = relative(s);
  const double w = std::max(1e-6, turn.w());
  const Vec3 u = turn.vec();
  const Vec3 body = 2 * (w * v_step_ + u * (u.dot(v_step_) / w) - u.cross(v_step_));
  return {com_step_, q_FP_ * (turn * body)};
}

}  // namespace sonde
