// SPDX-License-Identifier: GPL-3.0-or-later
// The document in the window: what changes it, and is undone. actions/document_control_test.cpp
// saves and leaves it.

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>

#include "tests/ui/document/document_fixture.hpp"
#include "ui/document/pose_text.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(DocumentTest, a_drag_is_one_step_and_comes_back) {
  const Pose before = pose();
  drag(Qt::LeftButton, {500, 400}, {40, -25});
  const Pose after = pose();
  ASSERT_GT((after.p - before.p).norm(), 1e-4);
  EXPECT_EQ(document().stack().count(), 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(comes_to(before));
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(comes_to(after));
  EXPECT_FALSE(document().modified()) << "where the probe is, is no part of the file";
}

TEST_F(DocumentTest, a_drag_that_moves_nothing_is_no_step) {
  drag(Qt::LeftButton, {500, 400}, {0, 0});
  drag(Qt::RightButton, {500, 400}, {30, 0});
  EXPECT_EQ(document().stack().count(), 0);
}

TEST_F(DocumentTest, keys_held_down_are_one_step) {
  const Pose before = pose();
  for (int i = 0; i < 4; ++i) key(Qt::Key_Right);
  EXPECT_EQ(document().stack().count(), 1);
  act("undo");
  EXPECT_TRUE(comes_to(before));
}

TEST_F(DocumentTest, reset_can_be_undone) {
  drag(Qt::LeftButton, {500, 400}, {60, 0});
  const Pose dragged = pose();
  key(Qt::Key_R);
  EXPECT_TRUE(comes_to(window->session()->loaded().start));
  act("undo");
  EXPECT_TRUE(comes_to(dragged));
}

TEST_F(DocumentTest, gains_poses_and_starts_are_undone_in_their_order) {
  const Pose start = pose();
  drag(Qt::LeftButton, {500, 400}, {40, 0});
  const Pose dragged = pose();
  type("k_value", "700");
  act("start_from_here");
  EXPECT_TRUE(document().modified());
  EXPECT_LT((window->session()->loaded().start.p - dragged.p).norm(), 1e-12);
  act("undo");
  EXPECT_EQ(window->session()->loaded().start.p, start.p);
  EXPECT_EQ(window->session()->coupling().k, 700);
  act("undo");
  EXPECT_EQ(window->session()->coupling().k, 500);
  EXPECT_FALSE(document().modified()) << "as it was opened, by value";
  act("undo");
  EXPECT_TRUE(comes_to(start));
  for (int i = 0; i < 3; ++i) act("redo");
  EXPECT_TRUE(comes_to(dragged));
  EXPECT_EQ(window->session()->coupling().k, 700);
  EXPECT_LT((window->session()->loaded().start.p - dragged.p).norm(), 1e-12);
}

TEST_F(DocumentTest, numbers_place_the_probe) {
  auto* dock = window->findChild<QDockWidget*>("pose_panel");
  dock->show();
  dock->raise();
  const Pose before = pose();
  window->findChild<QComboBox*>("pose_unit")->setCurrentText("mm");
  type("pose_2", "150");
  Pose wanted = before;
  wanted.p.z() = 0.15;
  EXPECT_TRUE(comes_to(wanted));
  EXPECT_EQ(QApplication::focusWidget(), window->viewport().canvas());
  type("pose_5", "90");
  wanted.q = Quat(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitZ()));
  EXPECT_TRUE(comes_to(wanted));
  window->findChild<QComboBox*>("pose_turn")->setCurrentIndex(1);
  auto* angle = window->findChild<QLineEdit*>("pose_6");
  EXPECT_TRUE(wait_until([&] { return angle->text() == "90"; })) << angle->text().toStdString();
  type("pose_6", "1e999");
  EXPECT_TRUE(comes_to(wanted));
  act("undo");
  act("undo");
  EXPECT_TRUE(comes_to(before));
}

}  // namespace
}  // namespace sonde::ui::test
