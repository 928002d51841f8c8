// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupling/contact_force.hpp"

#include <gtest/gtest.h>

#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/penetration/contact/contact_clusters.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

ContactCluster cluster(const Vec3& at, const Vec3& normal, double multiplier) {
  ContactCluster out;
  out.contact = {.on_probe = at, .on_fixed = at, .normal = normal, .multiplier = multiplier};
  return out;
}

void add(ContactClusters& clusters, const ContactCluster& one) {
  clusters.items[static_cast<std::size_t>(clusters.size++)] = one;
}

/// By hand: 2 mm and 1 mm of multiplier at right angles, at 500 N/m: 1 N and 0.5 N.
TEST(ContactForce, of_contacts_at_right_angles_is_the_stiffness_times_each) {
  ContactClusters clusters;
  add(clusters, cluster({0.01, 0, 0}, Vec3::UnitX(), 2e-3));
  add(clusters, cluster({0, 0.01, 0}, Vec3::UnitY(), 1e-3));
  const Wrench wrench{.force = {1, 0.5, 0}};
  EXPECT_NEAR(force_per_multiplier(wrench, clusters, Vec3::Zero()), 500, 1e-9);
}

/// Two opposed contacts, an arm of 10 mm each, carry a couple: 0.01 N·m is 0.5 N at each.
TEST(ContactForce, of_a_couple_is_that_of_its_torque) {
  ContactClusters clusters;
  add(clusters, cluster({0.01, 0, 0}, Vec3::UnitY(), 1e-3));
  add(clusters, cluster({-0.01, 0, 0}, -Vec3::UnitY(), 1e-3));
  const Wrench wrench{.torque = {0, 0, 0.01}};
  EXPECT_NEAR(force_per_multiplier(wrench, clusters, Vec3::Zero()) * 1e-3, 0.5, 1e-9);
}

TEST(ContactForce, of_nothing_is_none) {
  EXPECT_EQ(force_per_multiplier({.force = {1, 0, 0}}, {}, Vec3::Zero()), 0);
}

/// Of a search: the forces of its contacts add up to k t, the closed form of the object norm.
TEST(ContactForce, adds_up_to_the_force_of_what_was_found) {
  const Pair pair{test::body(test::box({0.02, 0.03, 0.05})),
                  test::body(test::box({0.3, 0.3, 0.1}))};
  const Pose at{Quat(Eigen::AngleAxisd(0.1, Vec3(1, 2, 0).normalized())), {0.01, 0.02, 0.07}};
  const Separation s = separate_static(pair, at, {});
  ASSERT_EQ(s.status, Status::penetrating);
  const MassProperties& mass = pair.probe().mass;
  const Wrench wrench = object_norm_wrench(mass, s.device, s.separated, 800);
  const ContactClusters clusters = contact_clusters(s.contacts, mass.radius);
  const double each = force_per_multiplier(wrench, clusters, s.device * mass.com);
  Vec3 sum = Vec3::Zero();
  for (const ContactCluster& c : clusters) sum += each * c.contact.multiplier * c.contact.normal;
  EXPECT_LT((sum - wrench.force).norm(), 1e-3 * wrench.force.norm());
}

}  // namespace
}  // namespace sonde
