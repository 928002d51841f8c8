// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "engine/haptics/hand/simulated_device.hpp"

namespace sonde::test {

inline constexpr double T = 1e-3;

/// Without a hand, friction, damping or limits that matter.
inline SimulatedDeviceParameters bare(double mass = 0.1, double inertia = 5e-5) {
  SimulatedDeviceParameters p;
  p.translation = {.inertia = mass, .limit = 1e9};
  p.rotation = {.inertia = inertia, .limit = 1e9};
  return p;
}

inline Wrench force(double x, double y = 0, double z = 0) {
  Wrench w;
  w.force = {x, y, z};
  return w;
}
inline Wrench torque(double x, double y = 0, double z = 0) {
  Wrench w;
  w.torque = {x, y, z};
  return w;
}
inline Pose at(double x, double y = 0, double z = 0) { return {Quat::Identity(), {x, y, z}}; }
inline Pose turned(double angle, const Vec3& axis = Vec3::UnitX()) {
  return {Quat(Eigen::AngleAxisd(angle, axis)), Vec3::Zero()};
}
inline double angle_x(const SimulatedDevice& device) {
  const Quat& q = device.state().X_WD.q;
  return 2 * std::atan2(q.x(), q.w());
}

}  // namespace sonde::test
