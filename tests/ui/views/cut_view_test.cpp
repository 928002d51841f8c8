// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cut_view.hpp"

#include <gtest/gtest.h>
#include <vtkPlane.h>

#include "tests/support/shapes.hpp"
#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// Through (1, 2, 3), across z.
CutPlane across_z() {
  CutPlane out;
  out.on = true;
  out.point = Vec3(1, 2, 3);
  out.normal = Vec3::UnitZ();
  return out;
}

TEST(CutView, axes_of_a_plane_are_two_in_it_and_its_normal) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100; ++i) {
    const Vec3 normal = sonde::test::random_in_ball(random, 1).normalized();
    const Mat3 axes = axes_of_plane(normal);
    EXPECT_EQ(axes.col(2), normal);
    EXPECT_NEAR((axes.transpose() * axes - Mat3::Identity()).norm(), 0, 1e-12);
    EXPECT_NEAR(axes.determinant(), 1, 1e-12);
  }
}

TEST(CutView, a_square_lies_in_the_plane_and_an_arrow_points_to_what_is_cut_away) {
  Stage stage;
  CutView view(*stage.renderer, stage.shapes);
  view.set(across_z(), 0.5);
  view.show(stage.frame());
  ASSERT_EQ(texts_of(view), QStringList{"cut away"});
  const double length = view.labels()[0].at.z() - 3;
  EXPECT_GT(length, 0);
  EXPECT_NEAR((view.labels()[0].at - Vec3(1, 2, 3 + length)).norm(), 0, 1e-12);
  int squares = 0;
  for (vtkActor* actor : stage.seen()) {
    const Eigen::AlignedBox3d box = bounds_of(*actor);
    if ((box.sizes() - Vec3(1, 1, 0)).norm() > 1e-6) continue;
    ++squares;
    EXPECT_NEAR((box.center() - Vec3(1, 2, 3)).norm(), 0, 1e-6);
  }
  EXPECT_EQ(squares, 1);
  EXPECT_EQ(stage.seen().size(), 7u) << "and an arrow and two rings, with heads";
  CutPlane off = across_z();
  off.on = false;
  view.set(off, 0.5);
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
}

/// What lies where the normal points is not drawn: there VTK's plane is below zero.
TEST(CutView, the_plane_of_mappers_keeps_what_the_cut_does_not_take_away) {
  Stage stage;
  CutView view(*stage.renderer, stage.shapes);
  view.set(across_z(), 0.5);
  for (const double z : {2.5, 3.5}) {
    Vec3 x(7, -4, z);
    EXPECT_EQ(view.plane().EvaluateFunction(x.data()) < 0, across_z().cuts_away(x)) << z;
  }
}

TEST(CutView, it_is_moved_along_its_normal_and_turned_about_what_lies_in_it) {
  EXPECT_TRUE(CutView::draws({.turns = false, .axis = 2}));
  EXPECT_TRUE(CutView::draws({.turns = true, .axis = 0}));
  EXPECT_TRUE(CutView::draws({.turns = true, .axis = 1}));
  EXPECT_FALSE(CutView::draws({.turns = false, .axis = 0}));
  EXPECT_FALSE(CutView::draws({.turns = true, .axis = 2})) << "which would change nothing";
  Stage stage;
  CutView view(*stage.renderer, stage.shapes);
  view.set(across_z(), 0.5);
  const Handles handles = view.handles(0.02);
  EXPECT_EQ(handles.centre, Vec3(1, 2, 3));
  EXPECT_EQ(Vec3(handles.axes.col(2)), Vec3::UnitZ());
  EXPECT_EQ(handles.length, 0.02);
}

}  // namespace
}  // namespace sonde::ui::test
