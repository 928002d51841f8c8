// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/differenced_wrench.hpp"

#include <cmath>

#include "engine/geometry/rotation.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"

namespace sonde::test {
namespace {

double gyration(const MassProperties& mass) { return std::sqrt(mass.inertia.maxCoeff()); }

/// Rotations as lengths, torques as forces.
Mat6 in_lengths(const MassProperties& mass, const Mat6& x) {
  Vec6 scale;
  scale << Vec3::Ones(), Vec3::Constant(1 / gyration(mass));
  return scale.asDiagonal() * x * scale.asDiagonal();
}

/// With one step, of the depth. No value where a solution fails.
std::optional<DifferencedWrench> differences(FineSolver& solver, const MassProperties& mass,
                                             const Pose& X_FO, const FineSolver::Answer& here,
                                             double step) {
  DifferencedWrench out;
  out.step = step;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double size = step * here.depth / (i < 3 ? 1 : gyration(mass));
    const auto beside = [&](double sign) {
      return solver.solve(moved_by(mass, X_FO, sign * size * Vec6::Unit(i)), here.separated);
    };
    const auto ahead = beside(1), behind = beside(-1);
    if (!ahead || !behind) return std::nullopt;
    out.central.col(i) = (ahead->wrench - behind->wrench) / (2 * size);
    out.ahead.col(i) = (ahead->wrench - here.wrench) / size;
    out.behind.col(i) = (here.wrench - behind->wrench) / size;
    out.depth[i] = (ahead->depth - behind->depth) / (2 * size);
  }
  return out;
}

}  // namespace

Pose moved_by(const MassProperties& mass, const Pose& X_FO, const Vec6& motion) {
  const Vec3 com = X_FO * mass.com + motion.head<3>();
  const Quat q = (rotation_by(motion.tail<3>()) * X_FO.q).normalized();
  return {q, com - q * mass.com};
}

std::optional<FineSolver::Answer> FineSolver::solve(const Pose& X_FO, const Pose& from) {
  const Chart chart(mass_, X_FO);
  descent_.forget();
  const Descent::Outcome found =
      descent_.run(chart, chart.coordinates(from), {.residual = 1e-9, .steps = 200}, 0, Deadline{});
  if (!(found.residual < 1e-7)) return std::nullopt;
  Answer out{chart.pose(found.y), found.y.norm(), {}};
  const Wrench wrench = object_norm_wrench(mass_, X_FO, out.separated, 1);
  out.wrench << wrench.force, wrench.torque;
  return out;
}

std::optional<DifferencedWrench> differenced_wrench(const Body& probe, const Body& fixed,
                                                    const Pose& X_FO, const Pose& X_FQ,
                                                    double enough) {
  FineSolver solver(probe, fixed);
  const auto here = solver.solve(X_FO, X_FQ);
  if (!here) return std::nullopt;
  for (const double step : {1e-3, 2e-4, 4e-5, 8e-6}) {
    const auto wide = differences(solver, probe.mass, X_FO, *here, step);
    auto narrow = differences(solver, probe.mass, X_FO, *here, step / 2);
    if (!wide || !narrow) continue;
    const Chart chart(probe.mass, X_FO);
    const Vec6 way = chart.coordinates(here->separated) - chart.coordinates(X_FQ);
    narrow->from_given = way.norm() / here->depth;
    narrow->unsure = relative_difference(probe.mass, wide->central, narrow->central);
    if (narrow->unsure < enough) return narrow;
  }
  return std::nullopt;
}

double relative_difference(const MassProperties& mass, const Mat6& x, const Mat6& y) {
  return in_lengths(mass, x - y).norm() / in_lengths(mass, y).norm();
}

}  // namespace sonde::test
