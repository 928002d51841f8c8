// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/queries/pose_numbers.hpp"

#include <cmath>
#include <stdexcept>

#include "engine/text/number_text.hpp"

namespace sonde {

Pose pose_of_numbers(std::span<const double, 7> n) {
  for (const double x : n)
    if (!std::isfinite(x)) throw std::invalid_argument("a number of the pose is not finite");
  const Quat q(n[3], n[4], n[5], n[6]);
  const double length = q.norm();
  if (!(std::abs(length - 1) <= 1e-3))
    throw std::invalid_argument("the quaternion qw,qx,qy,qz has length " + number_text(length, 6) +
                                "; it must be 1 within 0.001");
  return {q.normalized(), Vec3(n[0], n[1], n[2])};
}

}  // namespace sonde
