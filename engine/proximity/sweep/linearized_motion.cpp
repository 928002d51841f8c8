// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/sweep/linearized_motion.hpp"

#include <algorithm>
#include <cmath>

namespace sonde {

LinearizedMotion linearized(const Motion& motion, const Vec3& centre) {
  const Motion::Velocity v = motion.velocity(0);
  const Vec3 arm = motion.at(0).R * (centre - motion.com());
  const double bend = 0.5 * motion.acceleration_per_radius();
  return {{v.linear + v.angular.cross(arm), v.angular}, {bend * arm.norm(), bend}};
}

DisplacementBound displacement_bound_along(const Motion& motion, const Vec3& centre) {
  const LinearizedMotion path = linearized(motion, centre);
  return {(path.course.linear.norm() + path.bend.linear) * (1 + 1e-9),
          motion.turn_bound() * (1 + 1e-12)};
}

DisplacementBound displacement_bound(const Transform& from, const Transform& to,
                                     const Vec3& centre) {
  // For rotations, |R − R₀| as an operator norm is the Frobenius norm divided by √2.
  return {(1 + 1e-12) * (to * centre - from * centre).norm(),
          (1 + 1e-12) * (to.R - from.R).norm() / std::sqrt(2.0)};
}

DisplacementBound deviation(const Transform& from, const Course& course, const Transform& to,
                            const LinearizedMotion& path, const Vec3& centre, double arm) {
  // From one pose to the other, arms r of the first move by (Q − 1) r. The antisymmetric part of Q
  // − 1 is a turn by a first-order vector, and the rest is of second order.
  const Vec3 went = to * centre - from * centre;
  const Mat3 Q = to.R * from.R.transpose();
  const Vec3 turned(0.5 * (Q(2, 1) - Q(1, 2)), 0.5 * (Q(0, 2) - Q(2, 0)),
                    0.5 * (Q(1, 0) - Q(0, 1)));
  const double rest = (0.5 * (Q + Q.transpose()) - Mat3::Identity()).norm();
  const auto along = [&](const Vec3& linear, const Vec3& turn) {
    return linear.dot(course.linear) + arm * arm * turn.dot(course.turn);
  };
  const double length = along(course.linear, course.turn);
  double u = 0, more = 0;
  if (length > 0) {
    u = std::clamp(along(went, turned) / length, 0.0, 1.0);
    more = std::clamp(along(path.course.linear, path.course.turn) / length, -u, 1 - u);
  }
  const Vec3& angular = path.course.turn;
  return {(1 + 1e-9) * ((went - u * course.linear).norm() +
                        (path.course.linear - more * course.linear).norm() + path.bend.linear),
          (1 + 1e-9) *
              ((turned - u * course.turn).norm() + rest + (angular - more * course.turn).norm() +
               angular.norm() * (turned.norm() + rest) + path.bend.turn)};
}

}  // namespace sonde
