// SPDX-License-Identifier: GPL-3.0-or-later
// The reference throughout is the coherent solver asked about the same device pose.
#include "engine/haptics/loop/local_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/geometry/chart.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/haptics/loop/contact_feed.hpp"
#include "engine/proximity/sweep/motion.hpp"
#include "tests/engine/haptics/loop/at_depth.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/contact_path.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::contact_pairs;
using test::contact_path;
using test::ContactPair;

double distance(const ContactPair& pair, const Pose& from, const Pose& to) {
  return Chart(pair.probe->mass, from).coordinates(to).norm();
}

/// How far a point of the probe is between the two poses, at most, m.
double farthest(const ContactPair& pair, const Pose& from, const Pose& to) {
  const Chart chart(pair.probe->mass, from);
  return Motion(chart, Vec6::Zero(), chart.coordinates(to)).farthest(pair.probe->mass.radius);
}

TEST(LocalContacts, at_the_pose_of_the_rows_the_answer_is_that_of_the_geometry) {
  for (const Method method : {Method::pdg, Method::pdt})
    for (const ContactPair& pair : contact_pairs()) {
      ContactFeed feed({pair.probe, pair.fixed}, method);
      feed.reset(contact_path(pair, 0), {});
      int in_contact = 0;
      for (int i = 0; i <= 300; ++i) {
        const LocalContacts& contacts = feed.refresh(contact_path(pair, i / 300.0), 0, 0, {});
        const LocalAnswer answer =
            separate_locally(pair.probe->mass, method, contacts, contacts.separation.device);
        ASSERT_NE(answer.separation.status, Status::failed);
        if (!contacts.separation.converged) continue;
        // The residual to which a descent is converged, and the gap that it leaves.
        EXPECT_LE(distance(pair, contacts.separation.separated, answer.separation.separated),
                  2e-4 * contacts.separation.depth + 1e-8)
            << pair.name << " tick " << i;
        in_contact += answer.separation.status == Status::penetrating;
      }
      EXPECT_GT(in_contact, 30) << pair.name;
    }
}

TEST(LocalContacts, depths_are_wrong_by_twice_the_motion_of_the_device_at_most) {
  for (const Method method : {Method::pdg, Method::pdt})
    for (const ContactPair& pair : contact_pairs()) {
      ContactFeed feed({pair.probe, pair.fixed}, method);
      feed.reset(contact_path(pair, 0), {});
      LocalContacts old = feed.contacts();
      int compared = 0;
      for (int i = 1; i <= 600; ++i) {
        const Pose device = contact_path(pair, i / 600.0);
        const LocalAnswer answer = separate_locally(pair.probe->mass, method, old, device);
        const LocalContacts now = feed.refresh(device, 0, 0, {});
        const double moved = distance(pair, old.separation.device, device);
        const bool followed = now.separation.converged && old.separation.converged &&
                              now.jumps == old.jumps && !answer.held_back;
        // By translation alone the metric is another one: a turn costs what it lifts the probe.
        const double bound =
            method == Method::pdg ? 2 * moved : 2 * farthest(pair, old.separation.device, device);
        if (followed) {
          EXPECT_LE(std::abs(answer.separation.depth - now.separation.depth),
                    1.01 * bound + 2e-4 * now.separation.depth + 1e-7)
              << pair.name << " tick " << i;
          compared += now.separation.status == Status::penetrating;
        }
        if (i % 3 == 0) old = now;
      }
      EXPECT_GT(compared, 60) << pair.name;
    }
}

// A box that comes down flat on a block: the rows are exact however old they are.
TEST(LocalContacts, a_fast_poke_is_met_between_two_refreshes) {
  const ContactPair pair = contact_pairs()[0];
  const auto at = [](double depth) { return Pose{Quat::Identity(), Vec3(0, 0, 0.075 - depth)}; };
  ContactFeed feed({pair.probe, pair.fixed}, Method::pdg);
  const LocalContacts& free = feed.reset(at(-0.003), {});
  ASSERT_EQ(free.separation.status, Status::separated);
  ASSERT_GT(free.reach, 0.006);
  for (const double depth : {-0.002, -1e-4, 1e-4, 0.001, 0.003}) {
    const LocalAnswer answer = separate_locally(pair.probe->mass, Method::pdg, free, at(depth));
    EXPECT_FALSE(answer.held_back);
    EXPECT_EQ(answer.separation.status, depth > 0 ? Status::penetrating : Status::separated);
    EXPECT_NEAR(answer.separation.depth, std::max(0.0, depth), 1e-6) << depth;
    if (depth < 0) continue;
    ASSERT_GT(answer.separation.contacts.size, 0);
    for (const Contact& c : answer.separation.contacts) {
      EXPECT_NEAR(c.normal.z(), 1, 1e-9);
      EXPECT_NEAR(c.gap, 0, 1e-6);
    }
  }
}

TEST(LocalContacts, a_turn_is_followed_exactly_where_a_corner_touches_a_plane) {
  // A tetrahedron that stands on a corner: its row holds at any turn about it.
  const ContactPair pair = contact_pairs()[1];
  const auto tilted = [](double angle) {
    return Pose{Quat(Eigen::AngleAxisd(0.4 + angle, Vec3(1, 0.3, 0).normalized())),
                Vec3(0, 0, 0.068)};
  };
  ContactFeed feed({pair.probe, pair.fixed}, Method::pdg);
  feed.reset(tilted(0), {});
  const LocalContacts old = feed.refresh(tilted(0), 0, 0, {});
  ASSERT_EQ(old.separation.status, Status::penetrating);
  const LocalAnswer answer = separate_locally(pair.probe->mass, Method::pdg, old, tilted(0.03));
  const LocalContacts now = feed.refresh(tilted(0.03), 0, 0, {});
  ASSERT_TRUE(now.separation.converged);
  EXPECT_FALSE(answer.held_back);
  EXPECT_NEAR(answer.separation.depth, now.separation.depth, 1e-3 * now.separation.depth);
}

TEST(LocalContacts, the_separated_pose_goes_no_farther_than_is_trusted) {
  for (const ContactPair& pair : contact_pairs()) {
    ContactFeed feed({pair.probe, pair.fixed}, Method::pdg);
    feed.reset(contact_path(pair, 0), {});
    LocalContacts old = feed.refresh(contact_path(pair, 0.4), 0, 0, {});
    old.reach = 1e-3;
    int held_back = 0;
    for (int i = 0; i <= 20; ++i) {
      const LocalAnswer answer =
          separate_locally(pair.probe->mass, Method::pdg, old, contact_path(pair, 0.4 + 0.02 * i));
      ASSERT_NE(answer.separation.status, Status::failed);
      EXPECT_LE(farthest(pair, old.separation.separated, answer.separation.separated),
                1.2 * 0.1 * pair.probe->mass.radius)  // a bound of it, in two charts
          << pair.name;
      held_back += answer.held_back;
    }
    EXPECT_GT(held_back, 5) << pair.name;  // far from the rows that is all they can say
  }
}

TEST(LocalContacts, what_is_no_pose_or_has_no_rows_fails) {
  const ContactPair pair = contact_pairs()[0];
  ContactFeed feed({pair.probe, pair.fixed}, Method::pdg);
  Pose bad = contact_path(pair, 0);
  EXPECT_EQ(separate_locally(pair.probe->mass, Method::pdg, feed.contacts(), bad).separation.status,
            Status::failed);  // never reset
  const LocalContacts& contacts = feed.reset(contact_path(pair, 0), {});
  bad.p.z() = std::numeric_limits<double>::infinity();
  const LocalAnswer answer = separate_locally(pair.probe->mass, Method::pdg, contacts, bad);
  EXPECT_EQ(answer.separation.status, Status::failed);
  EXPECT_STRNE(answer.separation.reason, "");
}

TEST(LocalContacts, neither_refreshing_nor_using_them_allocates) {
  for (const Method method : {Method::pdg, Method::pdt})
    for (const ContactPair& pair : contact_pairs()) {
      ContactFeed feed({pair.probe, pair.fixed}, method);
      feed.reset(contact_path(pair, 0), {});
      int in_contact = 0;
      test::AllocationCounter counter;
      for (int i = 0; i <= 300; ++i) {
        const LocalContacts& contacts = feed.refresh(contact_path(pair, i / 300.0), 0, 0, {});
        const LocalAnswer answer = separate_locally(pair.probe->mass, method, contacts,
                                                    contact_path(pair, (i + 1) / 300.0));
        in_contact += answer.separation.status == Status::penetrating;
      }
      counter.stop();
      EXPECT_EQ(counter.allocations(), 0u) << pair.name;
      EXPECT_EQ(counter.frees(), 0u) << pair.name;
      EXPECT_GT(in_contact, 30) << pair.name;
    }
}

// Reference: the motion by which the geometry's pose is made to lag.
TEST(LocalContacts, say_how_far_the_probe_lags_behind_their_optimum) {
  const auto probe = test::body(test::box({0.02, 0.03, 0.05}));
  const auto fixed = test::body(test::box({0.3, 0.3, 0.1}));
  const Pose device = test::at_depth(0.002);
  for (const Method method : {Method::pdg, Method::pdt}) {
    ContactFeed feed({probe, fixed}, method);
    feed.reset(test::at_depth(-0.001), {});
    const LocalContacts known = feed.refresh(device, 1, 0, {});
    const auto lag = [&](const LocalContacts& rows) {
      return separate_locally(probe->mass, method, rows, device).lag;
    };
    EXPECT_NEAR(lag(known), 0, 1e-6);
    LocalContacts behind = known;
    behind.reach = 0;
    behind.separation.separated.p.z() += 0.1 * probe->mass.radius + 0.001;
    EXPECT_NEAR(lag(behind), 0.001, 1e-5) << "beyond a tenth of the radius";
    LocalContacts without_rows = known;
    without_rows.size = 0;
    without_rows.separation.residual = 0.7;
    EXPECT_NEAR(lag(without_rows), 0.7 * known.separation.depth, 1e-9);
    if (method == Method::pdg) continue;
    LocalContacts not_turned = known;
    Pose& separated = not_turned.separation.separated;
    separated.q = rotation_by(Vec3(0, 0, 0.2)) * separated.q;
    const double turn = Chart(probe->mass, device).coordinates(separated).head<3>().norm();
    EXPECT_GT(turn, 1e-3);
    EXPECT_NEAR(lag(not_turned), turn, 1e-4);
  }
}

}  // namespace
}  // namespace sonde
