// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/rotation.hpp"

#include <cmath>
#include <limits>

#include "engine/base/elementary.hpp"

namespace sonde {

Vec3 rotation_vector(const Quat& q) noexcept {
  const double sine = q.vec().norm();
  if (sine == 0) return Vec3::Zero();
  const double angle = 2 * elementary::atan2(sine, std::abs(q.w()));
  return (q.w() < 0 ? -angle : angle) / sine * q.vec();
}

Quat rotation_by(const Vec3& vector) noexcept {
  const double angle = vector.norm();
  if (angle == 0) return Quat::Identity();
  return rotation_about(vector / angle, angle);
}

Quat rotation_about(const Vec3& axis, double angle) noexcept {
  const Vec3 v = elementary::sin(0.5 * angle) * axis;
  return {elementary::cos(0.5 * angle), v.x(), v.y(), v.z()};
}

Quat rotation_between(const Quat& from, const Quat& to, double part) noexcept {
  const double cosine = from.dot(to), angle = elementary::acos(std::abs(cosine));
  double of_from = 1 - part, of_to = part;
  if (std::abs(cosine) < 1 - std::numeric_limits<double>::epsilon()) {
    const double sine = elementary::sin(angle);
    of_from = elementary::sin((1 - part) * angle) / sine;
    of_to = elementary::sin(part * angle) / sine;
  }
  if (cosine < 0) of_to = -of_to;
  return Quat(of_from * from.coeffs() + of_to * to.coeffs());
}

double angle_between(const Quat& q, const Quat& r) noexcept {
  const Quat d = q * r.conjugate();
  return 2 * elementary::atan2(d.vec().norm(), std::abs(d.w()));
}

}  // namespace sonde
