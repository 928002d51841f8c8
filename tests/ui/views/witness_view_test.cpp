// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/witness_view.hpp"

#include <gtest/gtest.h>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

class WitnessViewTest : public testing::Test {
 protected:
  void SetUp() override {
    found.lower_bound = 0.006;
    found.witness = BoundWitness{.at = {0.1, 0.2, 0.3}, .depth = 0.008};
    frame.searched = &found;
  }
  Stage stage;
  BackgroundResult found{.device = {}, .nearest = {}, .pdt = {}, .lower_bound = {}};
  Frame frame = stage.frame();
  WitnessView view{*stage.renderer, stage.shapes};
};

/// A ball about the point, of the depth as its radius: its rings are that large but for their
/// thickness.
TEST_F(WitnessViewTest, a_ball_shows_how_far_the_point_moves_at_least) {
  view.show(frame);
  EXPECT_EQ(texts_of(view), QStringList{"moves 8.000 mm at least: bound 6.000 mm"});
  EXPECT_EQ(view.labels()[0].at, Vec3(0.1, 0.2, 0.3));
  const auto seen = stage.seen();
  ASSERT_EQ(seen.size(), 7u) << "a point, and three rings with heads";
  Eigen::AlignedBox3d all;
  for (vtkActor* actor : seen) all.extend(bounds_of(*actor));
  EXPECT_NEAR((all.center() - Vec3(0.1, 0.2, 0.3)).norm(), 0, 1e-3);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(all.sizes()[axis], 0.016, 1.5e-3) << axis;
}

TEST_F(WitnessViewTest, without_a_bound_or_a_witness_nothing_is_drawn) {
  view.show(frame);
  found.witness.reset();
  view.show(frame);
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
  found.witness = BoundWitness{.at = {0, 0, 0}, .depth = 0.001};
  found.lower_bound.reset();
  view.show(frame);
  EXPECT_TRUE(stage.seen().empty());
  frame.searched = nullptr;
  view.show(frame);
  EXPECT_TRUE(stage.seen().empty());
}

}  // namespace
}  // namespace sonde::ui::test
