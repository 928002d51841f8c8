// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/probe_view.hpp"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include <numbers>

#include "tests/support/shapes.hpp"
#include "tests/ui/views/stage.hpp"
#include "ui/views/surface.hpp"

namespace sonde::ui::test {
namespace {

/// A cube of 20 mm, held 10 mm above where the hand is.
class ProbeViewTest : public testing::Test {
 protected:
  void SetUp() override {
    stage.snapshot.separation.device.p = Vec3(0.1, 0, 0);
    stage.snapshot.separation.separated.p = Vec3(0.1, 0, 0.01);
  }
  Vec3 middle() {
    const auto seen = stage.seen();
    EXPECT_EQ(seen.size(), 1u);
    return seen.empty() ? Vec3(Vec3::Zero()) : Vec3(bounds_of(*seen[0]).center());
  }
  Stage stage;
  vtkSmartPointer<vtkPolyData> cube =
      make_surface(sonde::test::body(sonde::test::box({0.02, 0.02, 0.02}))->soup);
};

TEST_F(ProbeViewTest, the_probe_is_where_the_hand_holds_it_in_contact_or_not) {
  ProbeView view(*stage.renderer, *cube, true);
  EXPECT_TRUE(stage.seen().empty());
  view.show(stage.frame());
  EXPECT_NEAR((middle() - Vec3(0.1, 0, 0)).norm(), 0, 1e-6);
  stage.snapshot.separation.status = Status::separated;
  view.show(stage.frame());
  EXPECT_NEAR((middle() - Vec3(0.1, 0, 0)).norm(), 0, 1e-6);
  view.set_visible(false);
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
}

TEST_F(ProbeViewTest, the_ghost_is_on_its_way_to_the_separated_pose_in_contact_alone) {
  GhostView view(*stage.renderer, *cube, true);
  view.show(stage.frame());
  EXPECT_NEAR((middle() - Vec3(0.1, 0, 0.01)).norm(), 0, 1e-6);
  EXPECT_LT(stage.seen()[0]->GetProperty()->GetOpacity(), 0.6) << "the probe is seen through it";
  Frame half = stage.frame();
  half.swing = 0.5;
  view.show(half);
  EXPECT_NEAR((middle() - Vec3(0.1, 0, 0.005)).norm(), 0, 1e-6);
  stage.snapshot.separation.status = Status::separated;
  view.show(half);
  EXPECT_TRUE(stage.seen().empty());
}

TEST_F(ProbeViewTest, a_way_out_stands_where_it_was_found_with_its_depth) {
  FoundView view(*stage.renderer, *cube, true, &BackgroundResult::nearest, FoundView::Shape::wires,
                 "nearest", QColor(20, 165, 112));
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty()) << "it was not searched yet";
  BackgroundResult found{.device = {}, .nearest = {}, .pdt = {}, .lower_bound = {}};
  found.pdt = FoundSeparation{.depth = 1, .separated = {}};
  Frame frame = stage.frame();
  frame.searched = &found;
  view.show(frame);
  EXPECT_TRUE(stage.seen().empty()) << "the other one was found";
  found.nearest = FoundSeparation{.depth = 0.0075, .separated = {Quat::Identity(), {0, 0.3, 0}}};
  view.show(frame);
  EXPECT_NEAR((middle() - Vec3(0, 0.3, 0)).norm(), 0, 1e-6);
  EXPECT_EQ(texts_of(view), QStringList{"nearest, 7.500 mm"});
  EXPECT_EQ(stage.seen()[0]->GetProperty()->GetRepresentation(), VTK_WIREFRAME);
  found.nearest->depth = 0;  // the hand is free
  view.show(frame);
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
}

TEST_F(ProbeViewTest, what_goes_leaves_nothing_behind) {
  { ProbeView view(*stage.renderer, *cube, true); }
  { GhostView view(*stage.renderer, *cube, true); }
  EXPECT_EQ(stage.renderer->GetActors()->GetNumberOfItems(), 0);
  const auto solid = body_actor(*stage.renderer, *cube, Qt::red, true);
  const auto sheet = body_actor(*stage.renderer, *cube, Qt::red, false);
  EXPECT_TRUE(solid->GetProperty()->GetBackfaceCulling());
  EXPECT_FALSE(sheet->GetProperty()->GetBackfaceCulling()) << "it has two sides";
}

TEST(OnTheWay, leads_from_the_device_pose_to_the_separated_one) {
  MassProperties mass;
  mass.com = Vec3(0.1, -0.2, 0.3);
  const Pose from{Quat(Eigen::AngleAxisd(0.4, Vec3::UnitX())), Vec3(1, 0, 0)};
  const Pose to{Quat(Eigen::AngleAxisd(1.1, Vec3::UnitX())), Vec3(1, 2, 0)};
  EXPECT_NEAR((on_the_way(mass, from, to, 0).p - from.p).norm(), 0, 1e-12);
  EXPECT_NEAR((on_the_way(mass, from, to, 1).p - to.p).norm(), 0, 1e-12);
  const Pose half = on_the_way(mass, from, to, 0.5);
  const Vec3 centre = half * mass.com;
  EXPECT_NEAR((centre - 0.5 * (from * mass.com + to * mass.com)).norm(), 0, 1e-12);
}
}  // namespace
}  // namespace sonde::ui::test
