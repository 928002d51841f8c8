// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/rotation.hpp"

#include <cmath>

namespace sonde {

Vec3 rotation_vector(const Quat& q) noexcept {
  const double sine = q.vec().norm();
  if (sine == 0) return Vec3::Zero();
  const double angle = 2 * std::atan2(sine, std::abs(q.w()));
  return (q.w() < 0 ? -angle : angle) / sine * q.vec();
}

Quat rotation_by(const Vec3& vector) noexcept {
  const double angle = vector.norm();
  if (angle == 0) return Quat::Identity();
  return Quat(Eigen::AngleAxisd(angle, vector / angle));
}

}  // namespace sonde
