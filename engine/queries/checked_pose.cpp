// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/queries/checked_pose.hpp"

#include "engine/penetration/descent/result.hpp"

namespace sonde {
namespace {

constexpr double farthest_of_motion = 1e150;  // m

}  // namespace

Pose checked_pose(const Pose& X) {
  if (const char* fault = fault_of(X)) throw InputError(fault);
  return {X.q.normalized(), X.p};
}

Pose checked_pose_of_motion(const Pose& X) {
  Pose out = checked_pose(X);
  if (X.p.cwiseAbs().maxCoeff() > farthest_of_motion)
    throw InputError("the pose is too far from the origin to compute with");
  return out;
}

}  // namespace sonde
