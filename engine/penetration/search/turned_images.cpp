// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/turned_images.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "engine/geometry/mass.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/penetration/descent/descent_tuning.hpp"

namespace sonde {
namespace {

/// Maximum fold of a symmetry. (With 4, 6, 12 and 24, 17, 14, 12 and 12 of 321 searches of bits,
/// bayonets, gratings and planet gears in their seats were over 1 % too deep.)
constexpr int most_folds = 12;

}  // namespace

std::vector<Vec6> turned_images(const Chart& chart, const MassProperties& fixed, const Vec6& end,
                                double nearer) {
  const MassProperties& probe = chart.mass();
  const Pose at = chart.pose(end);
  std::vector<Vec6> out;
  const auto turn_about = [&](const Vec3& axis, const Vec3& centre) {
    for (int n = 2; n <= most_folds; ++n)
      for (int m = 1; m < n; ++m) {
        if (std::gcd(n, m) > 1) continue;
        const Quat turn = rotation_about(axis, 2 * std::numbers::pi * m / n);
        const Vec6 y =
            chart.coordinates({(turn * at.q).normalized(), turn * (at.p - centre) + centre});
        if (y.norm() < nearer && chart.v(y).norm() < descent_tuning.largest_start_v)
          out.push_back(y);
      }
  };
  for (int k = 0; k < 3; ++k) {
    turn_about(at.q * probe.R_MP.col(k), at.q * probe.com + at.p);
    turn_about(fixed.R_MP.col(k), fixed.com);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Vec6& a, const Vec6& b) { return a.norm() < b.norm(); });
  return out;
}

}  // namespace sonde
