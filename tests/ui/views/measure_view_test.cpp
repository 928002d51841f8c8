// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/measure_view.hpp"

#include <gtest/gtest.h>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

class MeasureViewTest : public testing::Test {
 protected:
  Stage stage;
  MeasureView view{*stage.renderer, stage.shapes};
};

TEST_F(MeasureViewTest, one_point_says_where_it_is_and_how_far_from_the_other_body) {
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
  view.add({.on_probe = false, .x = {0.01, -0.002, 0}, .gap = 0.0005});
  view.show(stage.frame());
  EXPECT_EQ(texts_of(view),
            QStringList{"at 10.000 mm, -2.000 mm, 0.000 mm; 0.500 mm from the other body"});
  ASSERT_EQ(stage.seen().size(), 1u) << "a ball";
  EXPECT_NEAR((bounds_of(*stage.seen()[0]).center() - Vec3(0.01, -0.002, 0)).norm(), 0, 1e-9);
}

/// The probe is 1 mm further in z: (3, 4, 12) mm lie between, which are 13.
TEST_F(MeasureViewTest, two_points_have_a_distance_that_follows_the_probe) {
  view.add({.on_probe = false, .x = {0, 0, 0}, .gap = 0});
  view.add({.on_probe = true, .x = {0.003, 0.004, 0.011}, .gap = 0});
  stage.snapshot.separation.device.p = Vec3(0, 0, 0.001);
  view.show(stage.frame());
  EXPECT_EQ(texts_of(view), QStringList{"13.000 mm apart (3.000 mm, 4.000 mm, 12.000 mm)"});
  EXPECT_NEAR((view.labels()[0].at - Vec3(0.0015, 0.002, 0.006)).norm(), 0, 1e-12);
  EXPECT_EQ(stage.seen().size(), 3u) << "two balls and a line";
  stage.snapshot.separation.device.p = Vec3(-0.003, -0.004, 0);
  view.show(stage.frame());
  EXPECT_TRUE(texts_of(view)[0].startsWith("11.000 mm apart"));
}

TEST_F(MeasureViewTest, a_third_point_begins_another_measurement) {
  for (const double x : {1.0, 2.0, 3.0}) view.add({.on_probe = false, .x = {x, 0, 0}, .gap = 0});
  ASSERT_EQ(view.points().size(), 1u);
  EXPECT_EQ(view.points()[0].x.x(), 3);
  view.show(stage.frame());
  EXPECT_EQ(stage.seen().size(), 1u);
  view.clear();
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
}

}  // namespace
}  // namespace sonde::ui::test
