// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/workspace_map.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/elementary.hpp"
#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// The rows of the map whose source axis has the same kind, `first` to `first` + 2.
Mat3 matrix_of(const AxisMap& map, int first) {
  Mat3 matrix = Mat3::Zero();
  for (int i = 0; i < 3; ++i) {
    const AxisSetting& axis = map.axes[static_cast<std::size_t>(first + i)];
    const int source = axis.source - first;
    if (source < 0 || source > 2) continue;
    matrix(i, source) = axis.inverted ? -axis.gain : axis.gain;
  }
  return matrix;
}

/// rad: largest rotation from the anchor.
constexpr double farthest = std::numbers::pi / 2;

/// ω = J θ̇ for the rotation exp(θ), with ω in the outer frame.
Mat3 left_jacobian(const Vec3& theta) {
  const double a = theta.norm();
  constexpr double small = 1e-4;  // from here on the series is exact to rounding
  const double first = a < small ? 0.5 - a * a / 24 : (1 - elementary::cos(a)) / (a * a);
  const double second = a < small ? 1.0 / 6 - a * a / 120 : (a - elementary::sin(a)) / (a * a * a);
  Mat3 cross;
  cross << 0, -theta.z(), theta.y(), theta.z(), 0, -theta.x(), -theta.y(), theta.x(), 0;
  return Mat3::Identity() + first * cross + second * cross * cross;
}

/// The largest singular value.
double norm_of(const Mat3& map) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(map.transpose() * map, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

}  // namespace

void WorkspaceMap::configure(const AxisMap& axes, double scaling, const Quat& q_FB) noexcept {
  A_ = scaling * matrix_of(axes, 0);
  M_ = matrix_of(axes, 3);
  q_FB_ = q_FB;
}

void WorkspaceMap::anchor(const Pose& X_BH, const Pose& X_FC) noexcept {
  X_BH0_ = X_BH;
  X_FC0_ = X_FC;
  spin_ = M_;
}

Pose WorkspaceMap::follow(const Pose& X_BH) noexcept {
  const Vec3 theta = rotation_vector(X_BH.q * X_BH0_.q.conjugate());
  const Vec3 mapped = M_ * theta;
  const Quat turn = q_FB_ * rotation_by(mapped) * q_FB_.conjugate();
  Pose X_FC{(turn * X_FC0_.q).normalized(), X_FC0_.p + q_FB_ * (A_ * (X_BH.p - X_BH0_.p))};
  spin_ = left_jacobian(mapped) * M_ * left_jacobian(theta).inverse();
  if (const double angle = theta.norm(); angle > farthest) drag(theta / angle, X_BH, X_FC);
  return X_FC;
}

void WorkspaceMap::drag(const Vec3& axis, const Pose& X_BH, const Pose& X_FC) noexcept {
  const Quat back = rotation_by(-farthest * (M_ * axis));
  X_BH0_ = {(rotation_by(-farthest * axis) * X_BH.q).normalized(), X_BH.p};
  X_FC0_ = {(q_FB_ * back * q_FB_.conjugate() * X_FC.q).normalized(), X_FC.p};
}

DeviceWrench WorkspaceMap::on_handle(const Wrench& wrench) const noexcept {
  const Quat q_BF = q_FB_.conjugate();
  return {A_.transpose() * (q_BF * wrench.force), spin_.transpose() * (q_BF * wrench.torque)};
}

WorkspaceMap::Ratios WorkspaceMap::largest_ratios() const noexcept {
  return {norm_of(A_), norm_of(spin_)};
}

}  // namespace sonde
