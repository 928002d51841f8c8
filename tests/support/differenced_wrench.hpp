// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/penetration/descent/descent.hpp"

namespace sonde::test {

using Mat6 = Eigen::Matrix<double, 6, 6>;

/// The probe moved by (displacement of its centre of mass, rotation vector), both in F.
Pose moved_by(const MassProperties& mass, const Pose& X_FO, const Vec6& motion);

/// Where a descent ends that is solved far beyond what a search asks for: the residual to 1e-9 of
/// the depth, the clearance to 1e-8. (What a search leaves of either, 1e-4, would drown
/// differences.) Its wrench is the coupling's, and its depth √σ.
class FineSolver {
 public:
  FineSolver(const Body& probe, const Body& fixed)
      : mass_(probe.mass), descent_(probe, fixed, Method::pdg, {}, 1e-4) {}
  struct Answer {
    Pose separated;
    double depth = 0;
    Vec6 wrench = Vec6::Zero();
  };
  /// From a free pose. No value where it does not come so near.
  std::optional<Answer> solve(const Pose& X_FO, const Pose& from);

 private:
  const MassProperties& mass_;
  Descent descent_;
};

/// ∂(F, τ)/∂(δx, δφ) and ∂depth/∂(δx, δφ) by differences of the fine solver's answers.
struct DifferencedWrench {
  Mat6 central, ahead, behind;  ///< by central, forward and backward differences
  Vec6 depth;                   ///< central
  double from_given = 0;        ///< of the depth: how far its answer is from the free pose given
  double step = 0;              ///< of the depth: that the device is moved
  /// How much the central difference changes as the step is halved, of itself: what it is known to.
  double unsure = 0;
};
/// With the first step of 1e-3, 2e-4, 4e-5 and 8e-6 of the depth (a rotation by as much at the
/// radius of gyration) at which it is known to `enough`; no value where there is none.
std::optional<DifferencedWrench> differenced_wrench(const Body& probe, const Body& fixed,
                                                    const Pose& X_FO, const Pose& X_FQ,
                                                    double enough);

/// |x − y| / |y| with rotations times, and torques per, the probe's radius of gyration.
double relative_difference(const MassProperties& mass, const Mat6& x, const Mat6& y);

}  // namespace sonde::test
