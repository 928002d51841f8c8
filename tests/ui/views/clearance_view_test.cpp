// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/clearance_view.hpp"

#include <gtest/gtest.h>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// From (0, 0, 0) on the fixed body to (3, 0, 4) mm on the probe: 5 mm.
const GaugedClearance five_mm{
    .device = {}, .distance = 0.005, .on_probe = {0.003, 0, 0.004}, .on_fixed = {0, 0, 0}};

TEST(ClearanceView, a_line_leads_from_point_to_point_with_its_length_in_the_middle) {
  Stage stage;
  ClearanceView view(*stage.renderer, stage.shapes);
  Frame frame = stage.frame();
  frame.clearance = &five_mm;
  view.show(frame);
  ASSERT_EQ(texts_of(view), QStringList{"5.000 mm clear"});
  EXPECT_NEAR((view.labels()[0].at - Vec3(0.0015, 0, 0.002)).norm(), 0, 1e-12);
  const auto seen = stage.seen();
  ASSERT_EQ(seen.size(), 3u) << "two balls and a rod without a head";
  EXPECT_NEAR((bounds_of(*seen[0]).center() - five_mm.on_probe).norm(), 0, 1e-9);
  EXPECT_NEAR((bounds_of(*seen[1]).center() - five_mm.on_fixed).norm(), 0, 1e-9);
  const Eigen::AlignedBox3d rod = bounds_of(*seen[2]);
  EXPECT_NEAR((rod.center() - Vec3(0.0015, 0, 0.002)).norm(), 0, 1e-9);
  EXPECT_GT(rod.sizes().x(), 0.003);
  EXPECT_GT(rod.sizes().z(), 0.004);
}

TEST(ClearanceView, nothing_is_drawn_where_there_is_no_room_or_nobody_looks) {
  Stage stage;
  ClearanceView view(*stage.renderer, stage.shapes);
  Frame frame = stage.frame();
  frame.clearance = &five_mm;
  view.show(frame);
  frame.clearance = nullptr;
  view.show(frame);
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
  GaugedClearance none = five_mm;
  none.distance = 0;  // they touch
  frame.clearance = &none;
  view.show(frame);
  EXPECT_TRUE(stage.seen().empty());
  frame.clearance = &five_mm;
  view.set_visible(false);
  view.show(frame);
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
}

}  // namespace
}  // namespace sonde::ui::test
