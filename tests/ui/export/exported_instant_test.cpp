// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/exported_instant.hpp"

#include <gtest/gtest.h>

#include "tests/ui/export/made_up_instant.hpp"

namespace sonde::ui::test {
namespace {

Instant shown_instant() {
  const ExportedInstant made_up = made_up_instant();
  Instant now;
  now.snapshot.time = made_up.time;
  now.snapshot.separation = made_up.separation;
  now.snapshot.wrench = made_up.wrench;
  return now;
}

TEST(ExportedInstant, has_the_numbers_of_the_snapshot_and_the_probe_where_it_is_drawn) {
  const Instant now = shown_instant();
  const ExportedInstant out = exported_instant_of(now);
  EXPECT_EQ(out.time, 1.25);
  EXPECT_EQ(out.probe.p, now.snapshot.separation.device.p);
  EXPECT_EQ(out.probe.q.coeffs(), now.snapshot.separation.device.q.coeffs());
  EXPECT_EQ(out.separation.separated.p, now.snapshot.separation.separated.p);
  EXPECT_EQ(out.separation.clusters.size, 2);
  EXPECT_EQ(out.wrench.force, now.snapshot.wrench.force);
  EXPECT_EQ(out.wrench.torque, now.snapshot.wrench.torque);
}

TEST(ExportedInstant, has_what_was_searched_from_its_own_pose_alone) {
  Instant now = shown_instant();
  EXPECT_FALSE(exported_instant_of(now).searched);
  now.searched = BackgroundResult{};
  now.searched->device = now.snapshot.separation.device;
  now.searched->lower_bound = 0.017;
  ASSERT_TRUE(exported_instant_of(now).searched);
  EXPECT_EQ(exported_instant_of(now).searched->lower_bound, 0.017);
  now.searched->device.p.x() += 1e-6;
  EXPECT_FALSE(exported_instant_of(now).searched) << "the probe was elsewhere";
}

TEST(ExportedInstant, its_clearance_is_the_room_of_a_free_probe_and_minus_the_depth_of_a_held_one) {
  Instant now = shown_instant();
  EXPECT_EQ(exported_instant_of(now).clearance, -0.021);
  Separation& s = now.snapshot.separation;
  s = made_up_free_instant().separation;
  EXPECT_FALSE(exported_instant_of(now).clearance) << "it was not measured";
  now.clearance = GaugedClearance{.device = s.device, .distance = 0.004};
  EXPECT_EQ(exported_instant_of(now).clearance, 0.004);
  now.clearance->device.p.x() += 1e-6;
  EXPECT_FALSE(exported_instant_of(now).clearance) << "it was measured elsewhere";
}

TEST(SeparationInSteps, leads_from_the_device_pose_to_the_separated_one_within_a_second) {
  const Snapshot snapshot = shown_instant().snapshot;
  MassProperties probe;
  probe.com = Vec3(0.01, -0.02, 0.03);
  const std::vector<ExportedInstant> steps = separation_in_steps(snapshot, probe, 4);
  ASSERT_EQ(steps.size(), 5u);
  const Pose &from = snapshot.separation.device, &to = snapshot.separation.separated;
  EXPECT_LT((steps.front().probe.p - from.p).norm(), 1e-15);
  EXPECT_LT(steps.front().probe.q.angularDistance(from.q), 1e-7);
  EXPECT_LT((steps.back().probe.p - to.p).norm(), 1e-15);
  EXPECT_LT(steps.back().probe.q.angularDistance(to.q), 1e-7);
  const Vec3 com_from = from * probe.com, com_to = to * probe.com;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double part = double(i) / 4;
    EXPECT_EQ(steps[i].time, part);
    EXPECT_LT((steps[i].probe * probe.com - (com_from + part * (com_to - com_from))).norm(), 1e-12)
        << "the centre of mass goes straight";
    EXPECT_NEAR(from.q.angularDistance(steps[i].probe.q), part * 0.1, 1e-9) << "turned evenly";
    EXPECT_EQ(steps[i].separation.depth, 0.021) << "the separation stays what it is";
    EXPECT_EQ(steps[i].wrench.force, snapshot.wrench.force);
  }
}

TEST(SeparationInSteps, has_both_ends_however_few_are_asked_for) {
  for (const int steps : {1, 0, -3})
    EXPECT_EQ(separation_in_steps(shown_instant().snapshot, {}, steps).size(), 2u) << steps;
}

}  // namespace
}  // namespace sonde::ui::test
