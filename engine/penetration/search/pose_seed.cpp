// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/pose_seed.hpp"

#include <algorithm>
#include <bit>

namespace sonde {
namespace {

std::uint64_t mixed(std::uint64_t z) {
  z += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

}  // namespace

std::uint64_t seed_of_pose(std::uint64_t seed, const Pose& X_FM) {
  const Eigen::Vector4d q = X_FM.q.coeffs();
  const auto first = std::find_if(q.begin(), q.end(), [](double x) { return x != 0; });
  const double sign = first != q.end() && *first < 0 ? -1 : 1;
  const Vec3& p = X_FM.p;
  std::uint64_t out = mixed(seed);
  for (const double x : {p.x(), p.y(), p.z(), sign * q[0], sign * q[1], sign * q[2], sign * q[3]})
    out = mixed(out ^ std::bit_cast<std::uint64_t>(x + 0.0));
  return out;
}

}  // namespace sonde
