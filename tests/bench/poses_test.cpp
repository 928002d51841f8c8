// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/poses.hpp"

#include <gtest/gtest.h>

#include "tests/bench/meshes.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::bench {
namespace {

// Reference: every pair of triangles, without trees.
void check_poses(const Body& body, bool linked) {
  const PoseSet set = make_poses(body, body, linked, {4, 6, 3}, 11);
  const auto each = [&](Place place, const auto& check) {
    for (const Pose& pose : set.poses.at(place)) check(Transform(pose));
  };
  const auto gap = [&](const Transform& X) { return test::least_distance_of_pairs(body, body, X); };
  EXPECT_EQ(set.poses.count(Place::far), linked ? 0u : 1u);
  if (!linked) each(Place::far, [&](const Transform& X) { EXPECT_NEAR(gap(X), 2, 0.02); });
  each(Place::near_5, [&](const Transform& X) { EXPECT_NEAR(gap(X), 0.05, 0.0005); });
  each(Place::near_1, [&](const Transform& X) { EXPECT_NEAR(gap(X), 0.01, 0.0001); });
  each(Place::touching, [&](const Transform& X) { EXPECT_NEAR(gap(X), 1e-6, 1e-8); });
  each(Place::trajectory, [&](const Transform& X) { EXPECT_NEAR(gap(X), 0.01, 0.0001); });
  for (const Place place : {Place::shallow, Place::deep})
    each(place, [&](const Transform& X) { EXPECT_TRUE(test::any_pair_meets(body, body, X)); });
  EXPECT_EQ(set.poses.at(Place::deep).size(), 4u);
  EXPECT_EQ(set.poses.at(Place::trajectory).size(), 6u);
  ASSERT_EQ(set.trips.size(), 3u);
  for (const Trip& trip : set.trips) EXPECT_GT(gap(Transform(trip.from)), 0);
}

TEST(Poses, gaps_are_what_their_names_say) {
  check_poses(*test::body(ring_mesh(128)), false);
  check_poses(*test::body(trefoil_mesh(320)), false);
}

TEST(Poses, linked_rings_stay_linked) { check_poses(*test::body(ring_mesh(128)), true); }

TEST(Poses, the_same_seed_gives_the_same_bits) {
  const auto ring = test::body(ring_mesh(128));
  const auto make = [&](std::uint64_t seed) {
    return make_poses(*ring, *ring, false, {2, 2, 1}, seed);
  };
  const PoseSet a = make(5), b = make(5), c = make(6);
  for (const auto& [place, poses] : a.poses)
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_EQ(poses[i].p, b.poses.at(place)[i].p);
      EXPECT_EQ(poses[i].q.coeffs(), b.poses.at(place)[i].q.coeffs());
    }
  EXPECT_NE(a.poses.at(Place::deep)[0].p, c.poses.at(Place::deep)[0].p);
}

TEST(Meshes, have_the_triangles_and_the_size_that_were_asked_for) {
  for (const std::string name : {"sphere-1k", "ring-10k", "trefoil-10k", "trefoil-100k"}) {
    const PolygonSoup soup = mesh(name);
    const double asked = std::stod(name.substr(name.find('-') + 1)) * 1000;
    EXPECT_NEAR(static_cast<double>(soup.polygons.size()), asked, 0.15 * asked) << name;
    double radius = 0;
    for (const Vec3& x : soup.points) radius = std::max(radius, x.norm());
    EXPECT_NEAR(radius, mesh_radius, 1e-12) << name;
  }
  EXPECT_THROW(mesh("cone-1k"), std::invalid_argument);
}

}  // namespace
}  // namespace sonde::bench
