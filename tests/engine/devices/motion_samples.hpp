// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "engine/devices/device_motion.hpp"

// What devices report, and settings without smoothing, for tests of DeviceMotion.
namespace sonde::test {

inline const Vec3 com(0.01, -0.02, 0.03);
inline const Pose start{Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())),
                        Vec3(0.1, 0.2, 0.3)};

/// Every number of the pose.
inline bool same(const Pose& a, const Pose& b) {
  return a.p == b.p && a.q.coeffs() == b.q.coeffs();
}

/// Rounding of a centre of mass there and back.
inline void expect_near(const Pose& a, const Pose& b) {
  EXPECT_LT((a.p - b.p).norm(), 1e-15);
  EXPECT_LT((a.q.toRotationMatrix() - b.q.toRotationMatrix()).norm(), 1e-14);
}

inline DeviceSettings in_scene() {
  DeviceSettings settings;
  settings.frame = DeviceSettings::Frame::scene;
  settings.smoothing = 0;
  for (AxisSetting& axis : settings.axes.axes) axis.dead_zone = 0;
  return settings;
}

inline DeviceSample handle_at(const Vec3& p, double angle = 0, std::uint32_t buttons = 0) {
  return {.state = DeviceState::ready,
          .position = true,
          .session = 1,
          .buttons = buttons,
          .X_BH = {Quat(Eigen::AngleAxisd(angle, Vec3::UnitZ())), p}};
}

inline DeviceSample pushed(const SixAxes& deflection, std::uint32_t buttons = 0) {
  return {.state = DeviceState::ready, .session = 1, .buttons = buttons, .deflection = deflection};
}
inline SixAxes along(int axis, double by) {
  SixAxes deflection = SixAxes::Zero();
  deflection[axis] = by;
  return deflection;
}

}  // namespace sonde::test
