// SPDX-License-Identifier: GPL-3.0-or-later
// Touches and distances of whole bodies on soups and poses that are hard on floating point.
#include "tests/support/adversarial.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <limits>
#include <optional>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "tests/support/exact_reference.hpp"

namespace sonde {
namespace {

using test::BodyPair;
using test::HardPose;
using test::Placed;

/// How far from touching Doubt::contact may call a pair contact: classify()'s 32 roundings of the
/// largest coordinate along an axis, and as many again where that axis is itself a rounded one.
double doubt(const BodyPair& pair, const Transform& X) {
  return 64 * std::numeric_limits<double>::epsilon() * test::size_at(pair, X);
}
/// What distance.hpp promises.
double promised(const BodyPair& pair, const Transform& X) { return 1e-14 * test::size_at(pair, X); }

struct PoseCounts {
  int poses = 0, meeting = 0, near = 0, apart = 0, cautious = 0;
};

// Reference: meet_by_edges and exact distances over all pairs; and what is known of a pose by its
// construction. Trusted everywhere.
void check_touch(const BodyPair& pair, const HardPose& pose, const std::string& what,
                 PoseCounts& counts) {
  const Placed a(*pair.a, pose.X), b(*pair.b, {});
  const bool meet = test::any_meet(a, b);
  if (pose.kind == HardPose::Kind::touching) {
    ASSERT_TRUE(meet) << what << ": of the reference";
  }
  if (pose.kind == HardPose::Kind::ulps_off) {
    ASSERT_FALSE(meet) << what << ": of the reference";
  }
  EXPECT_EQ(triangles_meet(*pair.a, *pair.b, pose.X, Doubt::exact), meet) << what;
  const bool contact = triangles_meet(*pair.a, *pair.b, pose.X, Doubt::contact);
  EXPECT_GE(contact, meet) << what;
  ++counts.poses, counts.meeting += meet;
  if (meet || !contact) return;
  EXPECT_LE(test::least_exact_distance(a, b), doubt(pair, pose.X)) << what;
  ++counts.cautious;
}

void check_touches(std::uint64_t seed, int pairs, int triangles, int poses) {
  PoseCounts counts;
  test::for_adversarial_poses(
      seed, pairs, triangles, poses,
      [&](const BodyPair& pair, const HardPose& pose, const std::string& what) {
        check_touch(pair, pose, what, counts);
      });
  EXPECT_GT(counts.meeting, counts.poses / 5);
  EXPECT_LT(counts.meeting, counts.poses * 4 / 5);
  EXPECT_GT(counts.cautious, 0) << "some poses must be within rounding of touching";
  std::cout << counts.poses << " poses of 2 x " << triangles << " triangles, " << counts.meeting
            << " touching, " << counts.cautious << " in doubt\n";
}

TEST(Adversarial, touches_of_few_triangles) { check_touches(1, 4, 5, 6); }
TEST(Adversarial, touches_of_dozens) { check_touches(2, 2, 30, 5); }
TEST(Adversarial, touches_of_hundreds) { check_touches(3, 1, 400, 2); }
TEST(Adversarial, Full_touches) {
  check_touches(4, 50, 6, 20);
  check_touches(5, 10, 40, 20);
  check_touches(6, 1, 2000, 2);
}

// Reference: exact distances of all pairs.
void check_distance(const BodyPair& pair, const HardPose& pose, const std::string& what,
                    bool every_hint, PoseCounts& counts) {
  const Placed a(*pair.a, pose.X), b(*pair.b, {});
  const double expected = test::least_exact_distance(a, b);
  const double rounding = promised(pair, pose.X);
  const auto check = [&](std::optional<DistanceHint> hint) {
    Distance d = triangle_distance(*pair.a, *pair.b, pose.X, hint);
    EXPECT_NEAR(d.distance, expected, rounding) << what;
    EXPECT_NEAR((d.on_a - d.on_b).norm(), d.distance, rounding) << what;
    EXPECT_EQ(d.overlapping, d.distance <= 0) << what;
    return d;
  };
  const Distance d = check({});
  const auto na = static_cast<std::uint32_t>(surface(*pair.a).triangles.size());
  const auto nb = static_cast<std::uint32_t>(surface(*pair.b).triangles.size());
  ASSERT_LT(d.triangle_a, na);
  ASSERT_LT(d.triangle_b, nb);
  EXPECT_NEAR(test::exact_distance(a.triangles[d.triangle_a], b.triangles[d.triangle_b]),
              d.distance, rounding)
      << what;
  check(DistanceHint{d.triangle_a, d.triangle_b});
  check(DistanceHint{na, nb - 1});
  check(DistanceHint{std::numeric_limits<std::uint32_t>::max(), 1u << 31});
  const std::uint32_t step = every_hint ? 1 : na * nb / 3 + 1;
  for (std::uint32_t k = 0; k < na * nb; k += step) check(DistanceHint{k / nb, k % nb});
  ++counts.poses, counts.meeting += expected <= 0;
  (expected <= 100 * rounding ? counts.near : counts.apart) += expected > 0;
}

void check_distances(std::uint64_t seed, int pairs, int triangles, int poses, bool every_hint) {
  PoseCounts counts;
  test::for_adversarial_poses(
      seed, pairs, triangles, poses,
      [&](const BodyPair& pair, const HardPose& pose, const std::string& what) {
        check_distance(pair, pose, what, every_hint, counts);
      });
  EXPECT_GT(counts.near, counts.poses / 20);
  EXPECT_GT(counts.apart, counts.poses / 20);
  std::cout << counts.poses << " poses of 2 x " << triangles << " triangles: " << counts.meeting
            << " touching, " << counts.near << " nearly, " << counts.apart << " apart\n";
}

TEST(Adversarial, distances_of_few_triangles_from_every_hint) {
  check_distances(11, 3, 5, 4, true);
}
TEST(Adversarial, distances_of_dozens) { check_distances(12, 1, 30, 4, false); }
TEST(Adversarial, distances_of_hundreds) { check_distances(13, 1, 400, 1, false); }
TEST(Adversarial, Full_distances) {
  check_distances(14, 20, 6, 10, true);
  check_distances(15, 10, 40, 10, false);
  check_distances(16, 1, 1000, 2, false);
}

}  // namespace
}  // namespace sonde
