// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/pose_seed.hpp"

#include <algorithm>
#include <bit>

#include "engine/base/round_to_nearest.hpp"
#include "engine/geometry/random.hpp"

namespace sonde {

std::uint64_t seed_of_pose(std::uint64_t seed, const Pose& X_FM) {
  const RoundToNearest round_to_nearest;
  const Eigen::Vector4d q = X_FM.q.coeffs();
  const auto first = std::find_if(q.begin(), q.end(), [](double x) { return x != 0; });
  const double sign = first != q.end() && *first < 0 ? -1 : 1;
  const Vec3& p = X_FM.p;
  std::uint64_t out = Random(seed).next();
  for (const double x : {p.x(), p.y(), p.z(), sign * q[0], sign * q[1], sign * q[2], sign * q[3]})
    out = Random(out ^ std::bit_cast<std::uint64_t>(x + 0.0)).next();
  return out;
}

}  // namespace sonde
