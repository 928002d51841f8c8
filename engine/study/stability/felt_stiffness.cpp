// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/felt_stiffness.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "engine/base/elementary.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/haptics/coupling/object_damper.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/sensitivity/feature_row.hpp"
#include "engine/penetration/sensitivity/wrench_derivative.hpp"

namespace sonde {
namespace {

/// The device pose after a small motion about its centre of mass.
Pose moved(const MassProperties& mass, const Pose& X_FO, const Vec6& motion) {
  const Vec3 turn = motion.tail<3>();
  const Quat q = rotation_by(turn);
  const Vec3 com = X_FO * mass.com + motion.head<3>();
  const Quat turned = (q * X_FO.q).normalized();
  return {turned, com - turned * mass.com};
}

struct Springs {
  Vec6 object, classic;  ///< at unit gains
};

/// The solver's answers from Q to O and on to a neighbouring pose.
std::optional<Springs> springs(CoherentSolver& solver, const MassProperties& mass, const Pose& X_FQ,
                               const Pose& X_FO, const Pose& beside) {
  solver.reset(X_FQ);
  for (const Pose& X : {X_FO, beside}) {
    const Separation& s = solver.tick(X);
    if (s.status != Status::penetrating || s.jumped) return std::nullopt;
  }
  const Separation& s = solver.last();
  const Wrench wrench = object_norm_wrench(mass, s.device, s.separated, 1);
  const SeparationMotion motion = separation_motion(mass, s.device, s.separated);
  Springs out;
  out.object << wrench.force, wrench.torque;
  out.classic << motion.t, motion.theta;
  return out;
}

/// The derivative of the rotation vector θ of a rotation, for a small turn from the left.
Mat3 by_left_turn(const Vec3& theta) {
  const double angle = theta.norm();
  const Mat3 cross = cross_matrix(theta);
  const double second =
      angle < 1e-3 ? 1.0 / 12 : (1 - angle / (2 * elementary::tan(angle / 2))) / (angle * angle);
  return Mat3::Identity() - 0.5 * cross + second * cross * cross;
}

Mat6 felt_damper(const MassProperties& mass, Method method, const Separation& s) {
  const Mat6 Y = separation_jacobian(mass, method, s);
  return Y.transpose() * Y;
}

/// In closed form. No value if the answer fails, or if its derivative has more than one side.
std::optional<FeltStiffness> in_closed_form(CoherentSolver& solver, const Pair& pair,
                                            const Pose& X_FO, const Pose& X_FQ) {
  solver.reset(X_FQ);
  const Separation& s = solver.tick(X_FO);
  if (s.status != Status::penetrating || s.jumped) return std::nullopt;
  const WrenchDerivative d = wrench_derivative(pair, s);
  if (d.sides != WrenchDerivative::Sides::all) return std::nullopt;
  const Vec3 theta = separation_motion(pair.probe().mass, s.device, s.separated).theta;
  FeltStiffness out;
  out.object = -d.d_wrench;
  out.damper = felt_damper(pair.probe().mass, Method::pdg, s);
  out.classic = -d.d_separated;
  out.classic.topLeftCorner<3, 3>() += Mat3::Identity();
  out.classic.bottomRows<3>() =
      by_left_turn(theta) * Eigen::Matrix<double, 3, 6>(out.classic.bottomRows<3>());
  out.classic.bottomRightCorner<3, 3>() += by_left_turn(-theta);
  return out;
}

/// Î in the axes of the fixed frame.
Mat3 inertia_in_F(const MassProperties& mass, const Pose& X_FO) {
  const Mat3 R_FP = X_FO.q.toRotationMatrix() * mass.R_MP;
  return R_FP * mass.inertia.asDiagonal() * R_FP.transpose();
}

/// max xᵀ A x / xᵀ B x, with A symmetrised, over the range of B.
double largest_ratio(const Mat3& A, const Mat3& B) {
  const Eigen::SelfAdjointEigenSolver<Mat3> of_B(B);
  const double least = 1e-9 * of_B.eigenvalues().maxCoeff();
  Mat3 per_root = Mat3::Zero();
  for (Eigen::Index i = 0; i < 3; ++i)
    if (of_B.eigenvalues()[i] > least) per_root(i, i) = 1 / std::sqrt(of_B.eigenvalues()[i]);
  const Mat3 W = of_B.eigenvectors() * per_root;
  const Mat3 ratio = W.transpose() * (A + A.transpose()) / 2 * W;
  return Eigen::SelfAdjointEigenSolver<Mat3>(ratio).eigenvalues().maxCoeff();
}

}  // namespace

Mat6 FeltStiffness::stiffness(const Coupling& c) const {
  if (in_object_norm(c.mode)) return c.k * object;
  Mat6 out = classic;
  out.topRows<3>() *= c.k_t;
  out.bottomRows<3>() *= c.k_r;
  return out;
}

Mat6 FeltStiffness::damping(const Coupling& c) const {
  if (c.mode == Coupling::Mode::object) return Mat6::Zero();
  if (c.mode == Coupling::Mode::damped) return c.b_t * damper;
  Mat6 out = classic;
  out.topRows<3>() *= c.b_t;
  out.bottomRows<3>() *= c.b_r;
  return out;
}

std::optional<FeltStiffness> felt_stiffness(const Pair& pair, Method method, const Pose& X_FO,
                                            const Pose& X_FQ, double step) {
  constexpr double steps_of_clearance = 100;  // a difference is then exact to a hundredth
  const MassProperties& mass = pair.probe().mass;
  if (step < steps_of_clearance * allowed_clearance(mass.radius, 0)) return std::nullopt;
  // A turn about a thin axis moves little, so the step is measured by the motion of the whole
  // probe.
  const double radius = std::max(std::sqrt(mass.inertia.maxCoeff()), 1e-3 * mass.radius);
  CoherentSolver solver(pair, method);
  if (method == Method::pdg)
    if (auto known = in_closed_form(solver, pair, X_FO, X_FQ)) return known;
  FeltStiffness out;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double size = i < 3 ? step : step / radius;
    const auto beside = [&](double sign) {
      return springs(solver, mass, X_FQ, X_FO, moved(mass, X_FO, sign * size * Vec6::Unit(i)));
    };
    const auto ahead = beside(1), behind = beside(-1);
    if (!ahead || !behind) return std::nullopt;
    out.object.col(i) = (behind->object - ahead->object) / (2 * size);
    out.classic.col(i) = (behind->classic - ahead->classic) / (2 * size);
  }
  solver.reset(X_FQ);
  out.damper = felt_damper(mass, method, solver.tick(X_FO));
  return out;
}

StiffnessRatio stiffness_ratio(const MassProperties& mass, const Pose& X_FO, const Mat6& object) {
  return {largest_ratio(object.topLeftCorner<3, 3>(), Mat3::Identity()),
          largest_ratio(object.bottomRightCorner<3, 3>(), inertia_in_F(mass, X_FO))};
}

StiffnessRatio summed_penalty_ratio(const MassProperties& mass, const Separation& separation) {
  Mat6 sum = Mat6::Zero();
  for (const Contact& contact : separation.contacts) {
    Vec6 row;
    row << contact.normal,
        (contact.on_probe - separation.separated * mass.com).cross(contact.normal);
    sum += row * row.transpose();
  }
  return stiffness_ratio(mass, separation.device, sum);
}

}  // namespace sonde
