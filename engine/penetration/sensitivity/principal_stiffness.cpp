// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/sensitivity/principal_stiffness.hpp"

#include <Eigen/Eigenvalues>

#include "engine/base/round_to_nearest.hpp"

namespace sonde {
namespace {

std::array<PrincipalStiffness, 3> principal(const Mat3& stiffness) noexcept {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(0.5 * (stiffness + stiffness.transpose()));
  std::array<PrincipalStiffness, 3> out;
  for (int i = 0; i < 3; ++i)  // eigenvalues ascend
    out[static_cast<std::size_t>(2 - i)] = {solver.eigenvalues()[i], solver.eigenvectors().col(i)};
  return out;
}

}  // namespace

PrincipalStiffnesses principal_stiffnesses(const WrenchDerivative& derivative, double k) noexcept {
  const RoundToNearest round_to_nearest;
  const WrenchDerivative::Matrix stiffness = -k * derivative.d_wrench;
  return {principal(stiffness.topLeftCorner<3, 3>()),
          principal(stiffness.bottomRightCorner<3, 3>())};
}

}  // namespace sonde
