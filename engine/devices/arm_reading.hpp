// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/devices/device_sample.hpp"

namespace sonde {

/// A reading of an arm from its maker's library, in our units and frames.
struct ArmReading {
  enum class Kind {
    nothing,  ///< no new pose
    pose,
    fault,  ///< it cannot be used now; `words` say why; poses may follow later
    gone,   ///< the connection has ended
  };
  Kind kind = Kind::nothing;
  Pose X_BH{};
  std::uint32_t buttons = 0;
  std::string words{};
  DeviceClock::time_point time{};  ///< of the pose; none: the present
  /// The time at which a wrench was output, and the sample that it answers; none if the library
  /// outputs it immediately.
  DeviceClock::time_point answered{}, answers{};
};

/// No value if the matrix differs from a rotation by more than 1 % (OpenHaptics' are not exact).
inline std::optional<Quat> rotation_of(const Mat3& R) {
  constexpr double tolerance = 0.01;
  const double error = (R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff();
  if (!R.allFinite() || !(error <= tolerance) || R.determinant() < 0) return {};
  return Quat(R).normalized();
}
inline constexpr const char* no_rotation = "its rotation matrix is none, or not finite";

/// The properties of an arm, as its library reports them when it is opened.
struct ArmIdentity {
  std::string name, serial;
  DeviceCapabilities capabilities;
  /// m: a handle further from the base's origin is implausible.
  Vec3 farthest = Vec3::Constant(0.5);
};

}  // namespace sonde
