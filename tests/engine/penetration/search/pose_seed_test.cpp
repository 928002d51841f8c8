// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/pose_seed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace sonde {
namespace {

TEST(PoseSeed, one_pose_has_one_seed_however_it_is_written) {
  const Pose X{Quat(0.5, -0.5, 0.5, 0.5), Vec3(0.1, 0, -0.3)};
  Pose other = X;
  other.q.coeffs() = -X.q.coeffs();
  EXPECT_EQ(seed_of_pose(1, X), seed_of_pose(1, other));
  other.p.y() = -0.0;
  EXPECT_EQ(seed_of_pose(1, X), seed_of_pose(1, other));
  const Pose turned{Quat(0, 0, -1, 0), Vec3::Zero()};
  EXPECT_EQ(seed_of_pose(1, turned), seed_of_pose(1, {Quat(-0.0, -0.0, 1, -0.0), Vec3::Zero()}));
}

TEST(PoseSeed, poses_and_seeds_that_differ_in_one_bit_have_others) {
  const Pose X{Quat(0.5, -0.5, 0.5, 0.5), Vec3(0.1, 0.2, -0.3)};
  std::set<std::uint64_t> seeds{seed_of_pose(1, X), seed_of_pose(2, X), seed_of_pose(0, X)};
  const double up = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    Pose other = X;
    other.p[i] = std::nextafter(X.p[i], up);
    seeds.insert(seed_of_pose(1, other));
  }
  for (int i = 0; i < 4; ++i) {
    Pose other = X;
    other.q.coeffs()[i] = std::nextafter(X.q.coeffs()[i], up);
    seeds.insert(seed_of_pose(1, other));
  }
  seeds.insert(seed_of_pose(1, {X.q, Vec3(0.2, 0.1, -0.3)}));  // the same numbers, elsewhere
  EXPECT_EQ(seeds.size(), 11u);
}

}  // namespace
}  // namespace sonde
